// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/DelaunayFlips.h"

#include <algorithm>

namespace toile::meshing {
namespace {

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

/// The other diagonal of the two triangles at a side is the Delaunay one.
bool isToTurn(std::span<const GridPoint> points, const TriangleSides& sides, int side) {
    const int twin = sides.twinOf(side);
    if (twin < 0) return false;
    const GridPoint a = points[index(sides.startOf(side))], b = points[index(sides.endOf(side))];
    const GridPoint c = points[index(sides.apexOf(side))], d = points[index(sides.apexOf(twin))];
    const int where = circleSide(a, b, c, d);
    return where > 0 || (where == 0 && std::min(c, d) < std::min(a, b));
}

} // namespace

void DelaunayFlips::run(std::span<const GridPoint> points, TriangleSides& sides) {
    open_.clear();
    for (int side = static_cast<int>(sides.start.size()) - 1; side >= 0; --side)
        if (sides.twinOf(side) > side) open_.push_back(side);
    while (!open_.empty()) {
        const int side = open_.back();
        open_.pop_back();
        if (!isToTurn(points, sides, side)) continue;
        const int twin = sides.twinOf(side);
        turnDiagonal(sides, side);
        for (const int changed : {side, TriangleSides::previous(side), twin, TriangleSides::previous(twin)})
            open_.push_back(changed);
    }
}

} // namespace toile::meshing
