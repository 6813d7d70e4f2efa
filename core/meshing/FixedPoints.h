// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GrainSpans.h"
#include "core/meshing/SeamChain.h"

namespace toile::meshing {

/// Of all pieces.
using FixedPoints = std::pmr::vector<PiecePoints>;

/// Which edges of a piece are part of a seam: [loop][edge].
using SewnEdges = std::pmr::vector<std::pmr::vector<char>>;

/// Notches, ends of folds and of seam parts, carried across the seams to the edges they are sewn to; and on pieces of
/// the rule `regular` across the piece to free straight edges that face them along the grain; and under
/// `paper` where scan lines cross free edges.
[[nodiscard]] Result<FixedPoints> fixedPoints(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                                              std::span<const CheckedSeam> seams, Arena& arena);

[[nodiscard]] SewnEdges sewnEdges(const PieceInput& piece, int pieceIndex, std::span<const CheckedSeam> seams,
                                  Arena& arena);

} // namespace toile::meshing
