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

} // namespace toile::study
