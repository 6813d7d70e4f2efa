// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace toile::meshing {

/// Triangles as sides: side 3t + i runs from corner i of triangle t to the next. `twin` is the same side of the
/// neighbour, −1 = a wall.
struct TriangleSides {
    std::vector<int> start, twin;

    [[nodiscard]] static int next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }
    [[nodiscard]] static int previous(int side) { return side % 3 == 0 ? side + 2 : side - 1; }
    [[nodiscard]] int startOf(int side) const { return start[static_cast<std::size_t>(side)]; }
    [[nodiscard]] int endOf(int side) const { return startOf(next(side)); }
    [[nodiscard]] int apexOf(int side) const { return startOf(previous(side)); } ///< the corner across
    [[nodiscard]] int twinOf(int side) const { return twin[static_cast<std::size_t>(side)]; }
    [[nodiscard]] int triangles() const { return static_cast<int>(start.size() / 3); }
    [[nodiscard]] std::array<int, 3> corners(int triangle) const {
        return {startOf(3 * triangle), startOf(3 * triangle + 1), startOf(3 * triangle + 2)};
    }
};

/// Turns the diagonal `side` of the two triangles at it. Afterwards their four outer sides are `side`, the one before
/// it, and the same of what was its twin.
inline void turnDiagonal(TriangleSides& sides, int side) {
    const auto setTwin = [&](int one, int other) {
        sides.twin[static_cast<std::size_t>(one)] = other;
        if (other >= 0) sides.twin[static_cast<std::size_t>(other)] = one;
    };
    const int twin = sides.twinOf(side), after = TriangleSides::next(side), twinAfter = TriangleSides::next(twin);
    const int apex = sides.apexOf(side), twinApex = sides.apexOf(twin);
    const int outer = sides.twinOf(after), twinOuter = sides.twinOf(twinAfter);
    sides.start[static_cast<std::size_t>(after)] = twinApex;
    sides.start[static_cast<std::size_t>(twinAfter)] = apex;
    setTwin(side, twinOuter);
    setTwin(twin, outer);
    setTwin(after, twinAfter);
}

/// Divides a triangle at a point inside it. Returns the three sides across from the point.
inline std::array<int, 3> splitTriangle(TriangleSides& sides, int triangle, int vertex) {
    const int first = 3 * triangle, one = static_cast<int>(sides.start.size()), two = one + 3;
    const auto [a, b, c] = sides.corners(triangle);
    const int outerOne = sides.twinOf(first + 1), outerTwo = sides.twinOf(first + 2);
    sides.start[static_cast<std::size_t>(first) + 2] = vertex;
    sides.start.insert(sides.start.end(), {b, c, vertex, c, a, vertex});
    sides.twin.insert(sides.twin.end(), {outerOne, two + 2, first + 1, outerTwo, first + 2, one + 1});
    sides.twin[static_cast<std::size_t>(first) + 1] = one + 2;
    sides.twin[static_cast<std::size_t>(first) + 2] = two + 1;
    if (outerOne >= 0) sides.twin[static_cast<std::size_t>(outerOne)] = one;
    if (outerTwo >= 0) sides.twin[static_cast<std::size_t>(outerTwo)] = two;
    return {first, one, two};
}

} // namespace toile::meshing
