// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FlatTriangles.h"

namespace toile::meshing {
namespace {

/// Border nodes of a straight edge lie beside it by the rounding of the grid; what is flatter than this has
/// no area but for that rounding [units].
constexpr double flatHeight = 2;

/// The longest side of a flat triangle, or −1.
int longestOfFlat(std::span<const GridPoint> points, const TriangleSides& sides, int triangle) {
    const auto at = [&](int side) { return points[static_cast<std::size_t>(sides.startOf(side))]; };
    const auto square = [&](int side) {
        const GridPoint a = at(side), b = at(TriangleSides::next(side));
        const double x = static_cast<double>(a.x) - b.x, y = static_cast<double>(a.y) - b.y;
        return x * x + y * y;
    };
    const int first = 3 * triangle;
    const auto area = static_cast<double>(orientation(at(first), at(first + 1), at(first + 2)));
    int longest = first;
    for (const int side : {first + 1, first + 2})
        if (square(side) > square(longest)) longest = side;
    return area * area <= flatHeight * flatHeight * square(longest) ? longest : -1;
}

} // namespace

bool turnFlatTriangles(std::span<const int> triangles, std::span<const GridPoint> points, TriangleSides& sides) {
    bool turned = false;
    for (const int t : triangles) {
        const int side = longestOfFlat(points, sides, t);
        if (side < 0 || sides.twinOf(side) < 0) continue;
        const auto at = [&](int vertex) { return points[static_cast<std::size_t>(vertex)]; };
        const GridPoint apex = at(sides.apexOf(side)), far = at(sides.apexOf(sides.twinOf(side)));
        const GridPoint a = at(sides.startOf(side)), b = at(sides.endOf(side));
        if (orientation(apex, a, far) <= 0 || orientation(apex, far, b) <= 0) continue;
        turnDiagonal(sides, side);
        turned = true;
    }
    return turned;
}

} // namespace toile::meshing
