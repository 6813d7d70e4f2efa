// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/DividedBorders.h"
#include "core/meshing/PieceMesher.h"

namespace toile::meshing {

/// All that a piece without seams is meshed from.
struct PreparedPiece {
    PieceInput input;
    PieceBoundary boundary;
    Lattice lattice;
    FrozenBorder border;
};

/// The piece must pass the gate.
inline PreparedPiece prepared(const PieceInput& piece) {
    MeshInput input{{piece}, {}};
    const std::vector<PieceBoundary> boundaries{*checkedBoundary(piece)};
    const FixedPoints points = *fixedPoints(input, boundaries, {});
    const SpacingAlong spacing = [&](int, int, int, double, double) { return piece.spacing; };
    DividedBorders borders = *dividedBorders(input, boundaries, {}, points, spacing, {nullptr});
    std::vector<RegionReport> reports;
    std::vector<Warning> warnings;
    return {piece, boundaries[0],
            *laidLattice(piece, boundaries[0], {}, borders.division.grainStretches(piece, 0, boundaries[0]), reports,
                         warnings),
            std::move(*borders.borders[0])};
}

} // namespace toile::meshing
