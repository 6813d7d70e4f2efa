// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace toile::cloth {

/// Where in a list that stands which belongs to N nodes: a hash table with open addressing. What a list holds, and in
/// which order, does not depend on the hash.
template <std::size_t N>
class NodeIndex {
public:
    using Nodes = std::array<int, N>;

    /// Room for so many without growing.
    explicit NodeIndex(std::size_t expected = 0) { resize(expected); }

    /// The index these nodes were given first; `next` if they are new.
    int findOrAdd(const Nodes& nodes, int next) {
        if (2 * (used_ + 1) > slots_.size()) resize(2 * used_ + 8);
        Slot& slot = slotOf(nodes);
        if (slot.index < 0) {
            slot = {nodes, next};
            ++used_;
        }
        return slot.index;
    }

private:
    struct Slot {
        Nodes nodes{};
        int index = -1; ///< −1 = free
    };

    Slot& slotOf(const Nodes& nodes) {
        std::uint64_t hash = 0;
        for (const int node : nodes) hash = (hash ^ static_cast<std::uint32_t>(node)) * 0x9e3779b97f4a7c15ULL;
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = (hash ^ (hash >> 32)) & mask;
        while (slots_[at].index >= 0 && slots_[at].nodes != nodes) at = (at + 1) & mask;
        return slots_[at];
    }

    void resize(std::size_t expected) {
        std::size_t size = 16;
        while (size < 2 * expected) size *= 2;
        const std::vector<Slot> before = std::exchange(slots_, std::vector<Slot>(size));
        for (const Slot& slot : before)
            if (slot.index >= 0) slotOf(slot.nodes) = slot;
    }

    std::vector<Slot> slots_; ///< a power of two of them, at most half used
    std::size_t used_ = 0;
};

} // namespace toile::cloth
