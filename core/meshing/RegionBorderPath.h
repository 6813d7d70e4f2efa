// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Arena.h"
#include "core/geometry/Polygon.h"
#include "core/meshing/Lattice.h"

namespace toile::meshing {

/// A crossing of main lines.
struct LatticePoint {
    int column = 0, row = 0;
    friend auto operator<=>(const LatticePoint&, const LatticePoint&) = default;
};

/// A closed walk along main lines; each point differs from the one before in one coordinate.
using LatticePath = std::pmr::vector<LatticePoint>;

/// The painted border moved to main lines: each corner to the nearest crossing, and between two corners the
/// path of main cell edges that is cheapest in Σ (length + 4 · distance to the painted side) (Liu 2002, made
/// precise).
[[nodiscard]] LatticePath nearestLatticePath(std::span<const Vec2> border, const Lattice& lattice, Arena& arena);

} // namespace toile::meshing
