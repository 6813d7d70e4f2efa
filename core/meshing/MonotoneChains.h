// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/Crossings.h"

namespace toile::meshing {

/// A run of segments that follow one another, all of whose coordinates rise or fall together: it lies in the box of its
/// two ends, and so does every part of it.
struct MonotoneChain {
    int first = 0, last = 0; ///< segments first … last − 1
};

/// Rings of garment pieces consist of few such chains, and those of few places where boxes meet: some ten instructions
/// for each segment say that none cross.
[[nodiscard]] std::pmr::vector<MonotoneChain> monotoneChains(std::span<const RingSegment> segments, Arena& arena);

/// Some two segments meet elsewhere than at the common corner of neighbours. Empty where there are so many chains that
/// another search is faster.
[[nodiscard]] std::optional<bool> chainsCross(std::span<const RingSegment> segments, Arena& arena);

} // namespace toile::meshing
