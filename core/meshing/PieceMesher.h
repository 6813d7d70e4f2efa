// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/FinishedPiece.h"
#include "core/meshing/Lattice.h"
#include "core/meshing/PairMerge.h"
#include "core/meshing/Regions.h"
#include "core/meshing/StripImprovement.h"

namespace toile::meshing {

/// The main mesh with the regions on it.
struct LaidLattice {
    Lattice lattice;
    std::vector<RegionReport> regions;
    std::vector<Warning> warnings;
};

/// Lays the main mesh of one piece after another; keeps what it works in.
class LatticeLayer {
public:
    /// seamEnds are in the piece's frame. Overwrites what was laid.
    [[nodiscard]] Result<void> run(const PieceInput& piece, const PieceBoundary& boundary,
                                   std::span<const Vec2> seamEnds, const GrainStretches& stretches, Arena& arena,
                                   LaidLattice& laid);

private:
    IntegerLines lines_;
    BorderSegments segments_;
};

/// Meshes one piece after another. What it works in is kept: once it has meshed a piece, meshing another of the same
/// size takes no memory.
class PieceMesher {
public:
    /// From frozen border nodes to the finished mesh, which is overwritten.
    [[nodiscard]] Result<void> run(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& border,
                                   const std::vector<SpacingSeed>& seeds, const Lattice& laid, PieceMesh& mesh);

private:
    Lattice lattice_;
    std::vector<std::pair<int, int>> open_; ///< main cells, while they are balanced
    BorderSegments segments_;
    GridFiller filler_;
    GridFill fill_;
    CellLayer layer_;
    BoundaryNodes folded_; ///< the border's nodes with those of folds
    std::vector<Vec2> borderPlaces_;
    StripImprover improver_;
    Strip strip_;
    PairMerger merger_;
    PieceFinisher finisher_;
};

/// Overwrites the report by counts of the mesh; and, if it is to be judged, by all that can be said of it but its
/// regions, which stay.
void reportOn(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& nodes, const PieceMesh& mesh,
              bool judged, PieceReport& report);

} // namespace toile::meshing
