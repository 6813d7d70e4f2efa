// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/ClosestPoint.h"
#include "core/geometry/TriangleMesh.h"

#include <array>
#include <cstddef>
#include <vector>

namespace toile::collision {

class SurfaceNormals;

/// A hierarchy of boxes made for one question: which triangle is nearest to a point? Four boxes under a node are
/// looked at together, in single precision and a little too large; triangles are measured in full. The answer is that
/// of a search over all triangles.
class NearestTree {
public:
    /// The mesh has at least one triangle.
    NearestTree(const geometry::TriangleMesh& mesh, const SurfaceNormals& normals);

    /// The same boxes and triangles with the vertices moved; the farther from where it was made, the slower.
    void moveTo(const geometry::TriangleMesh& mesh);

    struct Found {
        int triangle = -1; ///< −1 = none so near
        TrianglePoint nearest{};
    };
    [[nodiscard]] Found nearest(const Vec3& point, double searchRadius) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    static constexpr int width = 4;
    struct alignas(64) Node {
        std::array<std::array<float, width>, 3> low, high; ///< by axis; of a child that is missing, +∞ and −∞
        std::array<int, width> child;                      ///< node, or −1 − leaf
    };
    struct Leaf {
        std::array<Vec3, 3> corners;
        int triangle = -1;
        bool isSliver = false; ///< where the mesh was when the tree was made
    };
    struct Search;

    std::vector<Node> nodes_; ///< root first
    std::vector<Leaf> leaves_;
    bool moved_ = false; ///< slivers are told when a triangle is measured: that is seldom
};

} // namespace toile::collision
