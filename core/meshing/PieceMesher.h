// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/FinishedPiece.h"
#include "core/meshing/Lattice.h"
#include "core/meshing/PairMerge.h"
#include "core/meshing/Regions.h"
#include "core/meshing/StripImprovement.h"

namespace toile::meshing {

/// The main mesh with the regions on it. seamEnds are in the piece's frame.
[[nodiscard]] Result<Lattice> laidLattice(const PieceInput& piece, const PieceBoundary& boundary,
                                          const std::vector<Vec2>& seamEnds, const GrainStretches& stretches,
                                          std::vector<RegionReport>& reports, std::vector<Warning>& warnings);

/// Meshes one piece after another. What it works in is kept: once it has meshed a piece, meshing another of the same
/// size takes no memory.
class PieceMesher {
public:
    /// From frozen border nodes to the finished mesh, which is overwritten.
    [[nodiscard]] Result<void> run(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& nodes,
                                   const std::vector<SpacingSeed>& seeds, const Lattice& laid, PieceMesh& mesh);

private:
    Lattice lattice_;
    std::vector<std::pair<int, int>> open_; ///< main cells, while they are balanced
    BorderSegments segments_;
    GridFiller filler_;
    GridFill fill_;
    CellLayer layer_;
    std::vector<Vec2> borderPlaces_;
    StripImprover improver_;
    Strip strip_;
    PairMerger merger_;
    PieceFinisher finisher_;
};

/// Counts of the mesh; and, if it is to be judged, all that PieceReport can say of it but its regions.
[[nodiscard]] PieceReport pieceReport(const PieceInput& piece, const PieceBoundary& boundary,
                                      const BoundaryNodes& nodes, const PieceMesh& mesh, bool judged);

} // namespace toile::meshing
