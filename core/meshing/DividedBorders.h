// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/Regions.h"

namespace toile::meshing {

/// What a piece's mesh is made of beside its lattice.
struct FrozenBorder {
    std::pmr::vector<double> description; ///< of its division: the nodes follow from it
    BoundaryNodes nodes;
    std::vector<SpacingSeed> seeds;
};

/// The border of a piece as it was frozen before, and as it is to be frozen now.
struct BorderMemory {
    FrozenBorder known, next;
    bool isKnown = false;
    bool isNext = false; ///< otherwise the known one stays
};

/// Divides all borders, finer where the polygon through the nodes would cross itself; freezes those that are new.
[[nodiscard]] Result<BoundaryDivision> divideBorders(const MeshInput& input,
                                                     const std::vector<PieceBoundary>& boundaries,
                                                     std::span<const CheckedSeam> seams, const FixedPoints& points,
                                                     const SpacingAlong& spacing, Arena& arena,
                                                     std::span<BorderMemory* const> borders);

} // namespace toile::meshing
