// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"
#include "core/simulation/TubePlacing.h"

#include <optional>

namespace toile::simulation {

/// Every point of a placed piece is twice the skin offset from the body, or farther.
[[nodiscard]] bool isClear(const std::vector<Vec2>& points, const pattern::Placement& placement,
                           const collision::BodySurface& body);

/// The placement moved outward, a tube widened about its middle, until it is clear of the body; as it was if
/// 15 cm do not help.
[[nodiscard]] pattern::Placement movedClear(const std::vector<Vec2>& points, const pattern::Placement& placement,
                                            const collision::BodySurface& body);

/// The piece rolled round a limb where it is asked for; where it is not clear of the body there, down the
/// limb or up it by up to 25 cm; where that does not help, wider by up to 3 cm. A piece that would reach
/// beyond `end` [m], the wrist or the ankle, is moved up first: what closes round a wrist seldom closes round
/// a hand. None if nothing helps.
[[nodiscard]] std::optional<pattern::Placement> clearRound(const geometry::Polyline& limb, double end,
                                                           const TubePlace& asked, const std::vector<Vec2>& points,
                                                           const collision::BodySurface& body);

} // namespace toile::simulation
