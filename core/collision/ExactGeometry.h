// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

/// Predicates without rounding on points of an integer grid. Coordinates have at most 40 bits, so that every
/// determinant here fits into 128.
namespace toile::collision::exact {

using Point = std::array<std::int64_t, 3>;
using Triangle = std::array<Point, 3>;

constexpr std::int64_t largestCoordinate = std::int64_t{1} << 39;

/// Whether a segment and a triangle, both with their borders, have a point in common. A triangle without area is its
/// three edges, a segment without length its point.
[[nodiscard]] bool segmentMeetsTriangle(const Point& p, const Point& q, const Triangle& triangle);

/// Whether two triangles, both with their borders, have a point in common: touching and lying on each other count.
[[nodiscard]] bool trianglesMeet(const Triangle& a, const Triangle& b);

} // namespace toile::collision::exact
