// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/FrameAlong.h"
#include "core/pattern/Pattern.h"

namespace toile::simulation {

/// How a piece is rolled round a limb.
struct TubePlace {
    Vec2 axis{0, 1};         ///< unit direction, in the piece, of the lines that go along the limb
    bool towardsEnd = false; ///< the axis points towards hand or foot; else towards the limb's root
    double at = 0;           ///< where along the limb the piece's origin lies [m]
    Vec3 upper{0, 1, 0};     ///< towards where the middle of the piece faces
    double middle = 0;       ///< where across the axis the middle of the piece lies [m]
    double radius = 0.1;     ///< [m]
};

/// The placement that rolls a piece round the middle line of a limb. It follows the line between the two
/// coordinates along the axis, `low` and `high` [m], where that is more than a millimetre off the straight.
[[nodiscard]] pattern::Placement placedRound(const geometry::Polyline& limb, const TubePlace& place, double low,
                                             double high);

/// Points all over a piece: on its outline and inside, 15 mm apart.
[[nodiscard]] std::vector<Vec2> pointsOn(const pattern::Piece& piece);

struct Extent {
    double low = 0, high = 0; ///< [m]
};
/// How far points reach along a direction of the piece.
[[nodiscard]] Extent extentAlong(const std::vector<Vec2>& points, Vec2 direction);

/// It wraps a limb more than half way round.
[[nodiscard]] bool isTube(const std::vector<Vec2>& points, const pattern::Placement& placement);

/// Across the axis of a curl, to the right of it.
[[nodiscard]] constexpr Vec2 acrossOf(Vec2 axis) {
    return {axis.y, -axis.x};
}

} // namespace toile::simulation
