// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"
#include "core/dynamics/BodyContact.h"
#include "core/simulation/Garment.h"
#include "core/simulation/Scene.h"
#include "core/simulation/StepPlan.h"

#include <memory>
#include <span>

namespace toile::simulation {

/// The contact stage of this garment with this body: distances from skin offset and thickness, friction from both,
/// and samples inside cells that are too coarse to follow a limb by their corners alone: one in the middle, and a net
/// of them in cells that lie near a bump of the body. Positions: of the particles, now [m]. bearsLayers: self-contact
/// follows, and presses cloth on to the body.
[[nodiscard]] std::unique_ptr<dynamics::Stage> bodyContactOf(const Scene& scene, const Garment& garment,
                                                             const collision::BodySurface& body,
                                                             std::span<const Vec3> positions, bool bearsLayers = false);

/// The stage of a plan that is contact with the body; null: it has none.
[[nodiscard]] dynamics::BodyContact* bodyContactIn(const StepPlan& plan);

} // namespace toile::simulation
