// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/ClusterTree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace toile::collision {

using geometry::Vec3;

ClusterTree::ClusterTree(std::span<const geometry::TriangleIndices> triangles, std::span<const Vec3> positions) {
    if (triangles.empty()) return;
    std::vector<Vec3> centres;
    centres.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) centres.push_back((positions[a] + positions[b] + positions[c]) / 3);
    triangles_.resize(triangles.size());
    std::iota(triangles_.begin(), triangles_.end(), 0);
    build(triangles_, centres);
    boxes_.resize(nodes_.size());
}

/// Halves the triangles along the longest axis of their centres; returns the node made.
int ClusterTree::build(std::span<int> triangles, std::span<const Vec3> centres) {
    const int node = static_cast<int>(nodes_.size());
    nodes_.push_back({});
    if (triangles.size() <= most) {
        nodes_[node].cluster = clusters();
        leaves_.push_back(node);
        begin_.push_back(begin_.back() + static_cast<int>(triangles.size()));
        return node;
    }
    Vec3 low = centres[triangles[0]], high = low;
    for (const int t : triangles)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], centres[t][axis]);
            high[axis] = std::max(high[axis], centres[t][axis]);
        }
    const Vec3 extent = high - low;
    const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
    const std::size_t half = (triangles.size() / 2 + most - 1) / most * most; // so that clusters are full
    std::ranges::nth_element(triangles, triangles.begin() + static_cast<std::ptrdiff_t>(half), [&](int s, int t) {
        return std::pair(centres[s][axis], s) < std::pair(centres[t][axis], t);
    });
    build(triangles.first(half), centres);
    const int second = build(triangles.subspan(half), centres);
    nodes_[node].second = second;
    return node;
}

/// What is below two nodes that are not both clusters, and near each other; the last is visited first. A way takes two
/// bits for each of at most 28 levels.
void ClusterTree::appendBelow(const Pair& pair, std::vector<Pair>& todo) const {
    const auto [a, b, left, way] = pair;
    const Node &first = nodes_[a], &second = nodes_[b];
    const auto append = [&, left = left, way = way](int one, int other, int bits, std::uint64_t turn) {
        if (one == other ? counts(one) : areNear(one, other))
            todo.push_back({one, other, left - bits, way | turn << (left - bits)});
    };
    if (a == b) {
        append(first.second, first.second, 2, 2);
        append(a + 1, a + 1, 2, 1);
        append(a + 1, first.second, 2, 0);
    } else if (second.second < 0 || (first.second >= 0 && first.second - a >= second.second - b)) {
        append(a + 1, b, 1, 1);
        append(first.second, b, 1, 0);
    } else {
        append(a, b + 1, 1, 1);
        append(a, second.second, 1, 0);
    }
}

std::vector<ClusterTree::Pair> ClusterTree::sharesOfSearch(std::size_t count) const {
    if (nodes_.empty()) return {};
    std::vector<Pair> shares{Pair{}}, next, below;
    while (shares.size() < count && shares != next) {
        next = std::move(shares);
        shares.clear();
        for (const Pair& pair : next) {
            below.clear();
            if (areClusters(pair)) below.push_back(pair);
            else appendBelow(pair, below);
            shares.insert(shares.end(), below.rbegin(), below.rend());
        }
    }
    return shares;
}

std::size_t ClusterTree::bytes() const {
    return (triangles_.capacity() + begin_.capacity() + leaves_.capacity()) * sizeof(int) +
           nodes_.capacity() * sizeof(Node) + boxes_.capacity() * sizeof(SweptBox) + counted_.capacity();
}

} // namespace toile::collision
