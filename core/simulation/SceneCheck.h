// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Problem.h"
#include "core/simulation/Scene.h"

#include <vector>

namespace toile::simulation {

inline constexpr double shortestFrameStep = 1e-4, longestFrameStep = 1; ///< [s]; integrators go so long at once
inline constexpr int mostSubsteps = 100'000;                            ///< of a frame step

/// Settings that no simulation can run with. Paths start at "scene".
[[nodiscard]] std::vector<pattern::Problem> checkScene(const SceneSettings& scene);

} // namespace toile::simulation
