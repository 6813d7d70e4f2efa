// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/Lattice.h"
#include "core/meshing/Regions.h"

namespace toile::meshing {

/// The finest spacing of the cells along a stretch of the border [m].
[[nodiscard]] double finestSpacingAlong(const PieceInput& piece, const PieceBoundary& boundary, const Lattice& lattice,
                                        int loop, int edge, double from, double to);

/// What the spacing of the frozen border nodes asks of the cells beside them; overwrites the list.
void listSeeds(const BoundaryNodes& nodes, const PieceFrame& frame, int pieceIndex, const BoundaryDivision& division,
               std::vector<SpacingSeed>& seeds);

/// Area enclosed by the curves themselves [m²].
[[nodiscard]] double exactArea(const PieceInput& piece);
/// Largest distance between the curves and the chords between nodes [m].
[[nodiscard]] double boundaryDeviation(const PieceInput& piece, const PieceBoundary& boundary,
                                       const BoundaryNodes& nodes);
/// The smallest angle of the piece at a border node [rad].
[[nodiscard]] double smallestBorderAngle(const BoundaryNodes& nodes);

} // namespace toile::meshing
