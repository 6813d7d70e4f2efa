// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace toile::cloth {

/// Finds the entries of a list by one of their nodes, which few of them share: each node names the newest of its
/// entries, each entry the one before it. Nodes are 0 … nodes − 1, entries are numbered as they come.
class NodeChains {
public:
    NodeChains(std::size_t nodes, std::size_t expected) : newest_(nodes, -1) { before_.reserve(expected); }

    /// The newest entry of a node that matches; −1 if there is none.
    template <class Matches>
    [[nodiscard]] int find(int node, Matches matches) const {
        int entry = newest_[node];
        while (entry >= 0 && !matches(entry)) entry = before_[entry];
        return entry;
    }
    /// The next entry of the list belongs to a node.
    void add(int node) { before_.push_back(std::exchange(newest_[node], static_cast<int>(before_.size()))); }

private:
    std::vector<int> newest_, before_;
};

} // namespace toile::cloth
