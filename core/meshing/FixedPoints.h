// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GrainSpans.h"
#include "core/meshing/SeamChain.h"

namespace toile::meshing {

/// Where nodes must lie on the border: [piece][loop][edge], rising fractions of arc length from 0 to 1.
using FixedPoints = std::vector<std::vector<std::vector<std::vector<double>>>>;

/// Notches and ends of seam parts, carried across the seams to the edges they are sewn to; and on pieces of
/// the rule `regular` across the piece to free straight edges that face them along the grain; and under
/// `paper` where scan lines cross free edges.
[[nodiscard]] Result<FixedPoints> fixedPoints(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                                              const std::vector<CheckedSeam>& seams);

/// Which edges of a piece are part of a seam: [loop][edge].
[[nodiscard]] std::vector<std::vector<char>> sewnEdges(const PieceInput& piece, int pieceIndex,
                                                       const std::vector<CheckedSeam>& seams);

} // namespace toile::meshing
