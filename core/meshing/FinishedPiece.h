// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/CellMesh.h"

namespace toile::meshing {

/// The mesh as consumers see it, and the new number of each of its nodes.
struct FinishedPiece {
    PieceMesh mesh;
    std::vector<int> numbers; ///< by node of the CellMesh
};

/// Numbers the nodes along a Morton curve, slaves last; turns everything back into the piece's coordinates.
[[nodiscard]] FinishedPiece finishedPiece(const PieceFrame& frame, const BoundaryNodes& boundary,
                                          const CellMesh& cells);

} // namespace toile::meshing
