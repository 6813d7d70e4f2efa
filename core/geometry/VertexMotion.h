// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

#include <vector>

namespace toile::geometry {

/// How the vertices of a mesh move: poses at equal steps of time, on straight ways between them, at rest after the
/// last.
struct VertexMotion {
    double step = 0;                      ///< from pose to pose [s]
    std::vector<std::vector<Vec3>> poses; ///< of all vertices [m]; the first is where the motion begins

    [[nodiscard]] double duration() const { return step * static_cast<double>(poses.size() - 1); }
    /// Where the vertices are so long after the beginning [s]; before it, as at it.
    void at(double time, std::vector<Vec3>& vertices) const;
    /// Where one of them is, to the same bit [m].
    [[nodiscard]] Vec3 vertexAt(std::size_t vertex, double time) const;
    /// The farthest that a vertex goes between two times [m], or a little more.
    [[nodiscard]] double farthest(double from, double to) const;
    friend bool operator==(const VertexMotion&, const VertexMotion&) = default;
};

/// Whether the mesh can move so: error when there is no second pose, time stands still, a pose has another number of
/// vertices or one that is no number, or the first is not where the mesh is, to within a tolerance [m].
[[nodiscard]] Result<void> checkedMotion(const VertexMotion& motion, const TriangleMesh& mesh, double tolerance);

} // namespace toile::geometry
