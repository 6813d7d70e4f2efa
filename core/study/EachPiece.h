// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

namespace toile::study {

/// The pattern with every piece changed.
template <class Change>
pattern::Pattern eachPiece(pattern::Pattern pattern, const Change& change) {
    for (auto& shared : pattern.pieces) {
        pattern::Piece piece = *shared;
        change(piece);
        shared = Shared<pattern::Piece>(std::move(piece));
    }
    return pattern;
}

/// Every mesh coarser by this factor, in regions too.
inline pattern::Pattern coarser(const pattern::Pattern& pattern, double factor) {
    return eachPiece(pattern, [factor](pattern::Piece& piece) { piece.spacing *= factor; });
}

/// One spacing everywhere, coarser by this factor; regions keep their stiffness and lose their finer mesh.
inline pattern::Pattern uniformCoarser(const pattern::Pattern& pattern, double factor) {
    return eachPiece(coarser(pattern, factor), [](pattern::Piece& piece) {
        for (auto& region : piece.regions) region.refinement = 0;
    });
}

} // namespace toile::study
