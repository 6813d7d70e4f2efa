// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"
#include "core/collision/SweptBox.h"
#include "core/geometry/TriangleMesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace toile::collision {

/// Clusters of a few triangles under a binary hierarchy of boxes. Its shape is fixed by where the triangles are at
/// first; the boxes are given anew for every search.
class ClusterTree {
public:
    static constexpr int most = 4; ///< triangles in a cluster

    ClusterTree() = default;
    ClusterTree(std::span<const geometry::TriangleIndices> triangles, std::span<const geometry::Vec3> positions);

    [[nodiscard]] int clusters() const { return static_cast<int>(begin_.size()) - 1; }
    [[nodiscard]] std::span<const int> trianglesOf(int cluster) const {
        return std::span(triangles_).subspan(begin_[cluster], begin_[cluster + 1] - begin_[cluster]);
    }
    [[nodiscard]] int clusterAt(int leaf) const { return nodes_[leaf].cluster; }
    [[nodiscard]] const SweptBox& boxAt(int node) const { return boxes_[node]; }
    [[nodiscard]] std::size_t bytes() const;

    /// From now on all count, and pairs are sought among all.
    void countAll() { counted_.clear(); }
    /// From now on only clusters of which counts(cluster) says so are fitted, and only pairs with one of them are
    /// sought.
    template <class Counts>
    void countOnly(const Counts& counts) {
        counted_.assign(nodes_.size(), 0);
        for (std::size_t n = nodes_.size(); n-- > 0;)
            counted_[n] = nodes_[n].second < 0 ? counts(nodes_[n].cluster)
                                               : counted_[n + 1] != 0 || counted_[nodes_[n].second] != 0;
    }
    /// Boxes round those that boxOf(cluster) gives.
    template <class BoxOf>
    void fit(Team* team, const BoxOf& boxOf) {
        constexpr int least = 200; // clusters for a thread: they take some microseconds
        inParts(team, clusters(), least, [&](int begin, int end) {
            for (int c = begin; c < end; ++c)
                if (counts(leaves_[c])) boxes_[leaves_[c]] = boxOf(c);
        });
        for (int n = static_cast<int>(nodes_.size()); n-- > 0;)
            if (const int second = nodes_[n].second; second >= 0 && counts(n))
                boxes_[n] = around(boxes_[n + 1], boxes_[second]);
    }

    /// Two nodes, and the way from the root to them: what is visited earlier has the lower one.
    struct Pair {
        int first = 0, second = 0;
        int left = 64; ///< bits of the way that are not used yet, at least 8 where clusters are reached
        std::uint64_t way = 0;
        friend bool operator==(const Pair&, const Pair&) = default;
    };
    /// visit(pair) once for every two clusters below these nodes whose boxes meet, and for every one with itself, until
    /// it returns false.
    template <class Visit>
    void forNearClusters(const Pair& from, const Visit& visit) const {
        std::vector<Pair> todo{from};
        while (!todo.empty()) {
            const Pair pair = todo.back();
            todo.pop_back();
            if (!areClusters(pair)) appendBelow(pair, todo);
            else if (!visit(pair)) return;
        }
    }
    /// Pairs, some `count` of them, below which all near clusters are found, in the order of a search from the root.
    [[nodiscard]] std::vector<Pair> sharesOfSearch(std::size_t count) const;

private:
    struct Node {
        int second = -1; ///< the first child follows its parent; −1 = leaf
        int cluster = -1;
    };

    int build(std::span<int> triangles, std::span<const geometry::Vec3> centres);
    [[nodiscard]] bool counts(int node) const { return counted_.empty() || counted_[node] != 0; }
    [[nodiscard]] bool areNear(int first, int second) const {
        return (counts(first) || counts(second)) && meet(boxes_[first], boxes_[second]);
    }
    [[nodiscard]] bool areClusters(const Pair& pair) const {
        return nodes_[pair.first].second < 0 && nodes_[pair.second].second < 0;
    }
    void appendBelow(const Pair& pair, std::vector<Pair>& todo) const;

    std::vector<int> triangles_, begin_{0}; ///< cluster by cluster, and where each begins
    std::vector<Node> nodes_;
    std::vector<int> leaves_; ///< nodes, by cluster
    std::vector<SweptBox> boxes_;
    std::vector<char> counted_; ///< nodes with a cluster that counts; empty = all do
};

} // namespace toile::collision
