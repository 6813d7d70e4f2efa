// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <utility>

namespace toile::meshing {

/// A point of a piece's integer grid. |coordinate| < 2²⁹, so that the predicates below are exact.
struct GridPoint {
    std::int32_t x = 0, y = 0;
    friend constexpr auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

__extension__ typedef __int128 WideInt; ///< for products of four coordinates

constexpr std::int32_t gridLimit = std::int32_t{1} << 29;

/// Twice the signed area of the triangle; positive when c lies to the left of a → b. Exact.
constexpr std::int64_t orientation(GridPoint a, GridPoint b, GridPoint c) {
    const std::int64_t abx = std::int64_t{b.x} - a.x, aby = std::int64_t{b.y} - a.y;
    const std::int64_t acx = std::int64_t{c.x} - a.x, acy = std::int64_t{c.y} - a.y;
    return abx * acy - aby * acx;
}

/// 1 where d lies inside the circle through the counter-clockwise a, b, c, 0 on it, −1 outside. Exact.
constexpr int circleSide(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
    const std::int64_t ax = std::int64_t{a.x} - d.x, ay = std::int64_t{a.y} - d.y;
    const std::int64_t bx = std::int64_t{b.x} - d.x, by = std::int64_t{b.y} - d.y;
    const std::int64_t cx = std::int64_t{c.x} - d.x, cy = std::int64_t{c.y} - d.y;
    const std::int64_t liftA = ax * ax + ay * ay, liftB = bx * bx + by * by, liftC = cx * cx + cy * cy;
    const WideInt sum = WideInt{liftA} * (bx * cy - by * cx) + WideInt{liftB} * (cx * ay - cy * ax) +
                        WideInt{liftC} * (ax * by - ay * bx);
    return (sum > 0) - (sum < 0);
}

/// An order of points that is the same on both sides of the piece's middle, x = 0: the nearer first, then the lower.
constexpr bool nearerMiddle(GridPoint a, GridPoint b) {
    const std::int32_t ax = a.x < 0 ? -a.x : a.x, bx = b.x < 0 ? -b.x : b.x;
    if (ax != bx) return ax < bx;
    return a.y != b.y ? a.y < b.y : a.x < b.x;
}

constexpr bool betweenInclusive(std::int32_t a, std::int32_t b, std::int32_t value) {
    return a <= b ? a <= value && value <= b : b <= value && value <= a;
}

/// The point lies on the closed segment.
constexpr bool onSegment(GridPoint a, GridPoint b, GridPoint point) {
    return orientation(a, b, point) == 0 && betweenInclusive(a.x, b.x, point.x) && betweenInclusive(a.y, b.y, point.y);
}

constexpr int signOf(std::int64_t value) {
    return (value > 0) - (value < 0);
}

/// The closed segments have a point in common.
constexpr bool segmentsMeet(GridPoint a, GridPoint b, GridPoint c, GridPoint d) {
    const int abc = signOf(orientation(a, b, c)), abd = signOf(orientation(a, b, d));
    const int cda = signOf(orientation(c, d, a)), cdb = signOf(orientation(c, d, b));
    if (abc * abd < 0 && cda * cdb < 0) return true;
    return onSegment(a, b, c) || onSegment(a, b, d) || onSegment(c, d, a) || onSegment(c, d, b);
}

/// A direction into the polygon's interior at the corner previous → corner → next; interior on the left.
constexpr bool insideCorner(GridPoint previous, GridPoint corner, GridPoint next, GridPoint towards) {
    const bool leftOfIncoming = orientation(previous, corner, towards) > 0;
    const bool leftOfOutgoing = orientation(corner, next, towards) > 0;
    return orientation(previous, corner, next) > 0 ? leftOfIncoming && leftOfOutgoing
                                                   : leftOfIncoming || leftOfOutgoing;
}

/// Interleaves the bits of both, 32 of each: neighbours in the plane stay near in order.
constexpr std::uint64_t interleaved(std::uint64_t x, std::uint64_t y) {
    const auto spread = [](std::uint64_t v) {
        v = (v | (v << 16)) & 0x0000ffff0000ffffULL;
        v = (v | (v << 8)) & 0x00ff00ff00ff00ffULL;
        v = (v | (v << 4)) & 0x0f0f0f0f0f0f0f0fULL;
        v = (v | (v << 2)) & 0x3333333333333333ULL;
        return (v | (v << 1)) & 0x5555555555555555ULL;
    };
    return spread(x) | (spread(y) << 1);
}

/// The place of a point along a Morton curve.
constexpr std::uint64_t mortonCode(GridPoint p) {
    const auto unsignedOf = [](std::int32_t v) { return static_cast<std::uint64_t>(std::int64_t{v} + gridLimit); };
    return interleaved(unsignedOf(p.x), unsignedOf(p.y));
}

} // namespace toile::meshing
