// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/KeyedNodes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

namespace toile::meshing {

void sortByKey(std::vector<KeyedNode>& nodes, std::vector<KeyedNode>& buffer) {
    if (nodes.empty()) return;
    std::uint64_t varying = 0;
    for (const KeyedNode& node : nodes) varying |= node.first ^ nodes.front().first;
    constexpr int digit = 8; // bits
    const int high = static_cast<int>(std::bit_width(varying));
    const int digits = std::max(1, (static_cast<int>(std::bit_width(nodes.size())) + 5) / digit);
    const int low = std::max(0, high - digits * digit);
    buffer.resize(nodes.size());
    for (int shift = low; shift < high; shift += digit) {
        std::array<std::size_t, (1 << digit) + 1> first{};
        const auto digitOf = [shift](std::uint64_t key) {
            return static_cast<std::size_t>((key >> shift) & ((1 << digit) - 1));
        };
        for (const KeyedNode& node : nodes) ++first[digitOf(node.first) + 1];
        std::partial_sum(first.begin(), first.end(), first.begin());
        for (const KeyedNode& node : nodes) buffer[first[digitOf(node.first)]++] = node;
        std::swap(nodes, buffer);
    }
    for (auto run = nodes.begin(); run != nodes.end();) {
        auto end = run + 1;
        while (end != nodes.end() && end->first >> low == run->first >> low) ++end;
        if (end - run > 1) std::sort(run, end);
        run = end;
    }
}

} // namespace toile::meshing
