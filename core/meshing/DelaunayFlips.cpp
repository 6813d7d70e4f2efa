// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/DelaunayFlips.h"

#include <algorithm>

namespace toile::meshing {
namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// Area and dot product of the two sides at a corner: proportional to the sine and cosine of its angle.
struct Corner {
    std::int64_t sine, cosine;
};

Corner cornerAt(GridPoint corner, GridPoint a, GridPoint b) {
    const std::int64_t ax = std::int64_t{a.x} - corner.x, ay = std::int64_t{a.y} - corner.y;
    const std::int64_t bx = std::int64_t{b.x} - corner.x, by = std::int64_t{b.y} - corner.y;
    return {ax * by - ay * bx, ax * bx + ay * by};
}

/// The other diagonal of the two triangles at a side is the Delaunay one: the corners across from it add up to more
/// than a straight angle. Exact, like the circle through three of the four points, and less work.
bool isToTurn(std::span<const GridPoint> points, const TriangleSides& sides, int side) {
    const int twin = sides.twinOf(side);
    if (twin < 0) return false;
    const GridPoint a = points[index(sides.startOf(side))], b = points[index(sides.endOf(side))];
    const GridPoint c = points[index(sides.apexOf(side))], d = points[index(sides.apexOf(twin))];
    const Corner left = cornerAt(c, a, b), right = cornerAt(d, b, a);
    const WideInt sineOfSum = WideInt{left.sine} * right.cosine + WideInt{left.cosine} * right.sine;
    return sineOfSum < 0 ||
           (sineOfSum == 0 && nearerMiddle(std::min(c, d, nearerMiddle), std::min(a, b, nearerMiddle)));
}

} // namespace

void DelaunayFlips::run(std::span<const GridPoint> points, TriangleSides& sides) {
    open_.clear();
    for (int side = static_cast<int>(sides.start.size()) - 1; side >= 0; --side)
        if (sides.twinOf(side) > side) open_.push_back(side);
    turnOpen(points, sides);
}

void DelaunayFlips::runFrom(std::span<const int> changed, std::span<const GridPoint> points, TriangleSides& sides) {
    open_.assign(changed.begin(), changed.end());
    turnOpen(points, sides);
}

void DelaunayFlips::turnOpen(std::span<const GridPoint> points, TriangleSides& sides) {
    turned_.clear();
    while (!open_.empty()) {
        const int side = open_.back();
        open_.pop_back();
        if (!isToTurn(points, sides, side)) continue;
        const int twin = sides.twinOf(side);
        turnDiagonal(sides, side);
        for (const int changed : {side, TriangleSides::previous(side), twin, TriangleSides::previous(twin)})
            open_.push_back(changed);
        turned_.push_back(side);
        turned_.push_back(twin);
    }
}

} // namespace toile::meshing
