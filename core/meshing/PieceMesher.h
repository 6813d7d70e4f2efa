// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/Lattice.h"
#include "core/meshing/Regions.h"

namespace toile::meshing {

/// The main mesh with the regions on it. seamEnds are in the piece's frame.
[[nodiscard]] Result<Lattice> laidLattice(const PieceInput& piece, const PieceBoundary& boundary,
                                          const std::vector<Vec2>& seamEnds, const GrainStretches& stretches,
                                          std::vector<RegionReport>& reports, std::vector<Warning>& warnings);

/// From frozen border nodes to the finished mesh.
[[nodiscard]] Result<PieceMesh> meshedPiece(const PieceInput& piece, const PieceBoundary& boundary,
                                            const BoundaryNodes& nodes, const std::vector<SpacingSeed>& seeds,
                                            Lattice lattice);

/// Counts of the mesh; and, if it is to be judged, all that PieceReport can say of it but its regions.
[[nodiscard]] PieceReport pieceReport(const PieceInput& piece, const PieceBoundary& boundary,
                                      const BoundaryNodes& nodes, const PieceMesh& mesh, bool judged);

} // namespace toile::meshing
