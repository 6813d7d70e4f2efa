// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"
#include "core/simulation/Frame.h"

#include <span>
#include <vector>

namespace toile::io {

/// One piece of a drape; triangles name vertices of the whole drape.
[[nodiscard]] std::span<const geometry::TriangleIndices>
trianglesOf(const simulation::FrameTopology& topology, const simulation::FrameTopology::PieceRange& piece);

/// Unit normals at the vertices, from the triangles of each piece alone: a seam stays a crease.
[[nodiscard]] std::vector<Vec3> drapeNormals(const simulation::FrameTopology& topology,
                                             std::span<const Vec3> positions);

/// Faces of three or four corners, in the order of their first triangles: two triangles are one face when the edge
/// between them is no line of the mesh.
[[nodiscard]] std::vector<std::vector<int>> facesOf(const simulation::FrameTopology& topology,
                                                    const simulation::FrameTopology::PieceRange& piece);

} // namespace toile::io
