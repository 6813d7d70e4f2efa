// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"
#include "core/simulation/Garment.h"
#include "core/simulation/Scene.h"

#include <memory>

namespace toile::simulation {

[[nodiscard]] bool hasPressure(const pattern::Pattern& pattern);

/// By how much gravity and air accelerate cloth of the scene at rest, at most [m/s²].
[[nodiscard]] double loadOf(const Scene& scene);

/// The drag of air on all of the cloth.
[[nodiscard]] std::unique_ptr<dynamics::Stage> windOn(const Scene& scene, const Garment& garment, const Air& air);

/// The air behind the pieces that say so. positions: of the particles now [m].
[[nodiscard]] std::unique_ptr<dynamics::Stage> pressureBehind(const Scene& scene, const Garment& garment,
                                                              std::span<const Vec3> positions);

} // namespace toile::simulation
