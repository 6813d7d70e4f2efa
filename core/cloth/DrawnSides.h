// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Patch.h"

namespace toile::cloth {

/// By how much a side of a cell is drawn up [–]; 1 where no stitching draws it. O(log drawn sides).
[[nodiscard]] double drawnBy(const Patch& patch, int a, int b);

/// A rectangle at rest, its sides drawn up: cloth is not stretched by it, so the other sides keep their lengths, and
/// both diagonals are those of a quadrangle in a circle (Ptolemy): d² = s₀s₂·a² + s₁s₃·b².
struct DrawnRectangle {
    std::array<double, 4> sides{}; ///< of node i to the next [m]
    double diagonal = 0;           ///< [m]
    bool drawn = false;            ///< one of its sides is
};

[[nodiscard]] DrawnRectangle drawnRectangle(const Patch& patch, const PatchRectangle& cell);

/// Places of a cell's corners in material coordinates when its sides are drawn up: each side about its middle.
template <std::size_t n>
[[nodiscard]] std::array<Vec2, n> drawnCorners(const Patch& patch, const std::array<int, n>& nodes) {
    std::array<Vec2, n> places;
    for (std::size_t i = 0; i < n; ++i) places[i] = patch.material[nodes[i]];
    if (patch.drawn.empty()) return places;
    const std::array<Vec2, n> cut = places;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const Vec2 half = 0.5 * (1 - drawnBy(patch, nodes[i], nodes[next])) * (cut[next] - cut[i]);
        places[i] = places[i] + half;
        places[next] = places[next] - half;
    }
    return places;
}

} // namespace toile::cloth
