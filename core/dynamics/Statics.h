// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Minimiser.h"

namespace toile::dynamics {

using StaticSettings = MinimiserSettings;

struct StaticReport {
    MinimiserReport newton;
    double displacementMaximum = 0; ///< how far the finish moved any particle [m]
};

/// Moves the state into equilibrium and stops it (velocities 0). The state changes also when the tolerance is not
/// reached: it is then the best found, and the report says so. team: to share work with; null = alone.
[[nodiscard]] Result<StaticReport> solveStatic(const cloth::ClothModel& model, ParticleState& state,
                                               const Vec3& gravity, std::span<Stage* const> stages,
                                               const StaticSettings& settings = {}, std::stop_token stop = {},
                                               const Progress& progress = {}, Team* team = nullptr);

} // namespace toile::dynamics
