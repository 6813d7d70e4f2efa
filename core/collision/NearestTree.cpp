// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/NearestTree.h"

#include "core/collision/BoxTree.h"
#include "core/collision/SurfaceNormals.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::collision {
namespace {

/// Rounding to single precision and the sums of a box distance, of a coordinate or a square [–].
constexpr double rounding = 1e-6;

/// The (up to) four nodes two levels below a node, leaves as soon as they come.
std::vector<int> grandchildren(const std::vector<BoxNode>& boxes, int node) {
    if (boxes[node].triangle >= 0) return {node};
    std::vector<int> found;
    for (const int child : {boxes[node].firstChild, boxes[node].firstChild + 1}) {
        if (boxes[child].triangle >= 0) found.push_back(child);
        else found.insert(found.end(), {boxes[child].firstChild, boxes[child].firstChild + 1});
    }
    return found;
}

} // namespace

NearestTree::NearestTree(const geometry::TriangleMesh& mesh, const SurfaceNormals& normals) {
    const std::vector<BoxNode> boxes = boxTreeOf(mesh);
    double farthest = 0; // coordinate
    for (int axis = 0; axis < 3; ++axis)
        farthest = std::max({farthest, std::abs(boxes[0].low[axis]), std::abs(boxes[0].high[axis])});
    const double margin = rounding * farthest;
    constexpr float nowhere = std::numeric_limits<float>::infinity();
    const auto leafOf = [&](int triangle) {
        const auto& [a, b, c] = mesh.triangles[triangle];
        leaves_.push_back(
            {{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]}, triangle, normals.isSliver(triangle)});
        return -static_cast<int>(leaves_.size());
    };
    leaves_.reserve(mesh.triangles.size());
    std::vector<int> from{0}; // the box that each node stands for
    for (std::size_t n = 0; n < from.size(); ++n) {
        Node node;
        for (auto& axis : node.low) axis.fill(nowhere);
        for (auto& axis : node.high) axis.fill(-nowhere);
        node.child.fill(-1);
        int i = 0;
        for (const int box : grandchildren(boxes, from[n])) {
            for (int axis = 0; axis < 3; ++axis) {
                node.low[axis][i] = static_cast<float>(boxes[box].low[axis] - margin);
                node.high[axis][i] = static_cast<float>(boxes[box].high[axis] + margin);
            }
            if (boxes[box].triangle >= 0) node.child[i] = leafOf(boxes[box].triangle);
            else {
                node.child[i] = static_cast<int>(from.size());
                from.push_back(box);
            }
            ++i;
        }
        nodes_.push_back(node);
    }
}

void NearestTree::moveTo(const geometry::TriangleMesh& mesh) {
    moved_ = true;
    double farthest = 0; // coordinate
    for (const Vec3& v : mesh.vertices) farthest = std::max({farthest, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    const double margin = rounding * farthest;
    for (Leaf& leaf : leaves_) {
        const auto& [a, b, c] = mesh.triangles[leaf.triangle];
        leaf.corners = {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
    }
    for (std::size_t n = nodes_.size(); n-- > 0;) { // children come after their parents
        Node& node = nodes_[n];
        for (int i = 0; i < width; ++i) {
            const int child = node.child[i];
            if (child == -1 && !std::isfinite(node.low[0][i])) continue; // missing
            for (std::size_t axis = 0; axis < 3; ++axis) {
                if (child < 0) {
                    const auto& [a, b, c] = leaves_[-1 - child].corners;
                    const int k = static_cast<int>(axis);
                    node.low[axis][i] = static_cast<float>(std::min({a[k], b[k], c[k]}) - margin);
                    node.high[axis][i] = static_cast<float>(std::max({a[k], b[k], c[k]}) + margin);
                } else {
                    const auto& [p, q, r, s] = nodes_[child].low[axis];
                    const auto& [t, u, v, w] = nodes_[child].high[axis];
                    node.low[axis][i] = std::min(std::min(p, q), std::min(r, s));
                    node.high[axis][i] = std::max(std::max(t, u), std::max(v, w));
                }
            }
        }
    }
}

std::size_t NearestTree::bytes() const {
    return nodes_.capacity() * sizeof(Node) + leaves_.capacity() * sizeof(Leaf);
}

/// Depth first, the nearer box first; boxes farther than the best triangle so far are left out.
struct NearestTree::Search {
    using Floats = float __attribute__((vector_size(16), may_alias));

    const NearestTree& tree;
    const Vec3& point;
    double bestSquared; ///< [m²]
    double margin;      ///< of the point's coordinates in single precision [m]
    float within = 0;   ///< squared distance of boxes that may hold something better [m²]
    const Leaf* leaf = nullptr;
    TrianglePoint best{};

    void narrow(double squared) {
        bestSquared = squared;
        const double reach = std::sqrt(squared) + margin;
        within = static_cast<float>(reach * reach * (1 + rounding));
    }

    void measure(const Leaf& candidate) {
        const auto& [a, b, c] = candidate.corners;
        const bool sliver = tree.moved_ ? collision::isSliver(candidate.corners) : candidate.isSliver;
        const TrianglePoint there = sliver ? closestOnSliver(point, a, b, c) : closestOnTriangle(point, a, b, c);
        const double squared = squaredLength(point - there.point);
        if (squared > bestSquared || (squared == bestSquared && leaf)) return;
        leaf = &candidate;
        best = there;
        narrow(squared);
    }

    void visit(int index) {
        const Node& node = tree.nodes_[index];
        Floats squared{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto p = static_cast<float>(point[axis]);
            const Floats below = *reinterpret_cast<const Floats*>(node.low[axis].data()) - p;
            const Floats above = p - *reinterpret_cast<const Floats*>(node.high[axis].data());
            Floats outside = below > above ? below : above;
            outside = outside > 0 ? outside : Floats{};
            squared += outside * outside;
        }
        std::array<int, width> order{0, 1, 2, 3};
        const auto sort = [&](int i, int k) {
            if (squared[order[k]] < squared[order[i]]) std::swap(order[i], order[k]);
        };
        sort(0, 1), sort(2, 3), sort(0, 2), sort(1, 3), sort(1, 2);
        for (const int i : order) {
            if (!(squared[i] <= within)) return;
            if (node.child[i] < 0) measure(tree.leaves_[-1 - node.child[i]]);
            else visit(node.child[i]);
        }
    }
};

NearestTree::Found NearestTree::nearest(const Vec3& point, double searchRadius) const {
    const double farthest = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
    Search search{*this, point, 0, rounding * farthest};
    search.narrow(searchRadius * searchRadius);
    search.visit(0);
    return search.leaf ? Found{search.leaf->triangle, search.best} : Found{};
}

} // namespace toile::collision
