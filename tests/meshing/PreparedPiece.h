// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Contracts.h"
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
    Arena arena;
    MeshInput input{{piece}, {}};
    std::vector<PieceBoundary> boundaries(1);
    expects(checkBoundary(piece, arena, boundaries[0]).has_value());
    const FixedPoints points = *fixedPoints(input, boundaries, {}, arena);
    const SpacingAlong spacing = [&](int, int, int, double, double) { return piece.spacing; };
    BorderMemory border;
    const std::array<BorderMemory*, 1> borders{&border};
    const auto division = divideBorders(input, boundaries, {}, points, spacing, arena, borders);
    LaidLattice laid;
    expects(LatticeLayer()
                .run(piece, boundaries[0], {}, division->grainStretches(piece, 0, boundaries[0], arena), arena, laid)
                .has_value());
    return {piece, boundaries[0], laid.lattice, border.next};
}

} // namespace toile::meshing
