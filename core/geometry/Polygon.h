// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <span>
#include <vector>

namespace toile::geometry {

/// A closed polyline; the last point joins the first. Counter-clockwise = positive area.
using Polygon = std::vector<Vec2>;

[[nodiscard]] double signedArea(std::span<const Vec2> polygon);
/// Winding number of the polygon round the point; on the border either answer may come.
[[nodiscard]] int windingNumber(std::span<const Vec2> polygon, Vec2 point);
/// Distance from the point to the border.
[[nodiscard]] double distanceToBorder(std::span<const Vec2> polygon, Vec2 point);
[[nodiscard]] Vec2 closestOnSegment(Vec2 a, Vec2 b, Vec2 point);

struct Box2 {
    Vec2 low, high;
};
/// The smallest axis-parallel box; of no points: an empty box at the origin.
[[nodiscard]] Box2 boundsOf(std::span<const Vec2> points);

} // namespace toile::geometry
