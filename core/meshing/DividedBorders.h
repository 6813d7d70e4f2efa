// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/Regions.h"

namespace toile::meshing {

/// What a piece's mesh is made of beside its lattice.
struct FrozenBorder {
    std::vector<double> description; ///< of its division: the nodes follow from it
    BoundaryNodes nodes;
    std::vector<SpacingSeed> seeds;
};

/// How the borders of all pieces are divided, and those that are new; empty where the known one stays.
struct DividedBorders {
    BoundaryDivision division;
    std::vector<std::optional<FrozenBorder>> borders;
};

/// Divides all borders, finer where the polygon through the nodes would cross itself. `known` has the border of each
/// piece that was divided before, or null.
[[nodiscard]] Result<DividedBorders> dividedBorders(const MeshInput& input,
                                                    const std::vector<PieceBoundary>& boundaries,
                                                    const std::vector<CheckedSeam>& seams, const FixedPoints& points,
                                                    const SpacingAlong& spacing,
                                                    const std::vector<const FrozenBorder*>& known);

} // namespace toile::meshing
