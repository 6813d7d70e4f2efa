// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"
#include "core/dynamics/Stage.h"
#include "core/simulation/Garment.h"
#include "core/simulation/Scene.h"

#include <memory>

namespace toile::simulation {

/// The contact stage of this garment with this body: distances from skin offset and thickness, friction from both,
/// and samples inside cells that are too coarse to follow a limb by their corners alone.
[[nodiscard]] std::unique_ptr<dynamics::Stage> bodyContactOf(const Scene& scene, const Garment& garment,
                                                             const collision::BodySurface& body);

} // namespace toile::simulation
