// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/ClosestPoint.h"
#include "core/geometry/TriangleMesh.h"

#include <array>
#include <vector>

namespace toile::collision {

/// Unit normals of all faces, edges and corners of a mesh. Those of an edge are the sum over its faces, those of a
/// corner the sum weighted by the angle of each face there: with them the sign of (p − nearest)·normal says whether p
/// is inside, whichever part of the surface is nearest. Corners at one position count as one, so that a mesh split at
/// its texture seams has no cracks. A part whose faces have no area has a zero normal.
/// Ref: Baerentzen & Aanaes 2005, Signed distance computation using the angle weighted pseudonormal.
class SurfaceNormals {
public:
    explicit SurfaceNormals(const geometry::TriangleMesh& mesh);

    [[nodiscard]] const Vec3& at(int triangle, TrianglePart part) const {
        return faces_[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(part)];
    }
    /// The corners lie on a line, to within rounding: the face has no normal of its own.
    [[nodiscard]] bool isSliver(int triangle) const { return at(triangle, TrianglePart::inside) == Vec3{}; }
    /// Every edge joins exactly two faces that run through it in opposite directions.
    [[nodiscard]] bool isClosed() const { return closed_; }
    [[nodiscard]] std::size_t bytes() const { return faces_.capacity() * sizeof(faces_[0]); }

private:
    std::vector<std::array<Vec3, 7>> faces_; ///< |F| × parts, in the order of TrianglePart
    bool closed_ = false;
};

/// Whether the corners of a triangle lie on a line, to within rounding.
[[nodiscard]] bool isSliver(const std::array<Vec3, 3>& corners);

/// The same normals of a mesh whose vertices move, each computed when it is asked for: of all there are, a substep asks
/// for few. Which corners are one and which faces meet stays as it was in the mesh it was made from.
class NormalsOnDemand {
public:
    explicit NormalsOnDemand(const geometry::TriangleMesh& mesh);
    /// With the vertices there now [m].
    [[nodiscard]] Vec3 at(const std::vector<Vec3>& vertices, int triangle, TrianglePart part) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    [[nodiscard]] std::array<Vec3, 3> cornersOf(const std::vector<Vec3>& vertices, int face) const;

    std::vector<geometry::TriangleIndices> faces_; ///< of vertices that stand for all at their position
    std::vector<int> firstFace_, facesAt_;         ///< of each vertex, the faces round it: |V| + 1 starts and the list
};

} // namespace toile::collision
