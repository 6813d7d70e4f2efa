// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/meshing/Lattice.h"
#include "core/meshing/PieceBoundary.h"

namespace toile::meshing {

/// Snaps the painted borders of a piece's regions to main lines and sets `division` and `region` of the
/// lattice. Where regions overlap the finer counts. Overwrites the reports, one of each region.
[[nodiscard]] Result<void> snapRegions(const PieceInput& piece, const PieceBoundary& boundary, Arena& arena,
                                       Lattice& lattice, std::span<RegionReport> reports,
                                       std::vector<Warning>& warnings);

/// Neighbouring active cells, also across corners, differ at most by a factor of two afterwards: the coarser
/// ones are divided further, in rings. `open` is room to work in.
void balance(Lattice& lattice, std::vector<std::pair<int, int>>& open);

/// A border node spacing that the cells there must not exceed more than twice.
struct SpacingSeed {
    Vec2 a, b;           ///< border segment in the frame [m]
    int largestDivision; ///< how far the seed may divide a cell
    friend bool operator==(const SpacingSeed&, const SpacingSeed&) = default;
};

/// Divides cells along the border until they suit its node spacing.
void seedFromBorder(const std::vector<SpacingSeed>& seeds, Lattice& lattice);

/// Refuses more cells than fit in memory.
[[nodiscard]] Result<void> affordable(const PieceInput& piece, const Lattice& lattice);
/// The same for the main lines alone, before the lattice is laid.
[[nodiscard]] Result<void> affordable(const PieceInput& piece, std::size_t linesX, std::size_t linesY);

} // namespace toile::meshing
