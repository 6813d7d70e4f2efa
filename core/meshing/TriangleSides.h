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

} // namespace toile::meshing
