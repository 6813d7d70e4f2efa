// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <vector>

namespace toile::geometry {

using TriangleIndices = std::array<int, 3>;

/// Triangles over shared vertices, counter-clockwise seen from outside.
struct TriangleMesh {
    std::vector<Vec3> vertices;             ///< [m]
    std::vector<TriangleIndices> triangles; ///< indices into vertices
    friend bool operator==(const TriangleMesh&, const TriangleMesh&) = default;
};

/// Volume enclosed, positive when the triangles face outward [m³]; meaningful for closed meshes.
[[nodiscard]] double signedVolume(const TriangleMesh& mesh);
/// Every edge is shared by exactly two triangles that run through it in opposite directions.
[[nodiscard]] bool isClosedManifold(const TriangleMesh& mesh);
/// Unit normals at the vertices, weighted by area; zero where a vertex has no area.
[[nodiscard]] std::vector<Vec3> vertexNormals(const TriangleMesh& mesh);
/// Vertices nearer than tolerance [m] become one; triangles that lose a corner go.
[[nodiscard]] TriangleMesh welded(const TriangleMesh& mesh, double tolerance);

struct Box3 {
    Vec3 low, high;
};
[[nodiscard]] Box3 boundsOf(const std::vector<Vec3>& points);

} // namespace toile::geometry
