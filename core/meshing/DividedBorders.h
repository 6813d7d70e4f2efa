// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"

namespace toile::meshing {

/// The borders of all pieces, divided: how, and the nodes of each piece.
struct DividedBorders {
    BoundaryDivision division;
    std::vector<BoundaryNodes> nodes;
};

/// Divides all borders, finer where the polygon through the nodes would cross itself.
[[nodiscard]] Result<DividedBorders> dividedBorders(const MeshInput& input,
                                                    const std::vector<PieceBoundary>& boundaries,
                                                    const std::vector<CheckedSeam>& seams, const FixedPoints& points,
                                                    const SpacingAlong& spacing);

} // namespace toile::meshing
