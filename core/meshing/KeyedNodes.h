// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace toile::meshing {

/// A node, or whatever has a number, and what it is sorted by.
using KeyedNode = std::pair<std::uint64_t, int>;

/// Sorts by key, then by node: counts over as many of the leading bits that vary as tell most nodes apart, then sorts
/// what is left. `buffer` is room to work in.
void sortByKey(std::vector<KeyedNode>& nodes, std::vector<KeyedNode>& buffer);

/// Calls use(span) for each run of two and more equal keys.
template <class Use>
void forEachDraw(std::vector<KeyedNode>& sorted, Use use) {
    for (std::size_t first = 0, end = 0; first < sorted.size(); first = end) {
        for (end = first + 1; end < sorted.size() && sorted[end].first == sorted[first].first;) ++end;
        if (end - first > 1) use(std::span(sorted).subspan(first, end - first));
    }
}

} // namespace toile::meshing
