// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/GlFunctions.h"
#include "core/picture/SurfaceData.h"

#include <array>
#include <vector>

namespace toile::picture {

/// A range of line indices in the buffer of a GlMesh.
struct LineRange {
    GLsizei first = 0, count = 0; ///< in indices
};

/// Vertices with their triangles and lines in the graphics card's memory.
struct GlMesh {
    GLuint vertexArray = 0, lineArray = 0;
    GLuint vertices = 0, triangles = 0, lines = 0;
    GLsizei triangleIndices = 0;
};

[[nodiscard]] GlMesh createMesh(const GlFunctions& gl);
void deleteMesh(const GlFunctions& gl, const GlMesh& mesh);
/// Replaces all vertices; meant for every frame.
void uploadVertices(const GlFunctions& gl, const GlMesh& mesh, const std::vector<SurfaceVertex>& vertices);
void uploadTriangles(const GlFunctions& gl, GlMesh& mesh, const std::vector<geometry::TriangleIndices>& triangles);
void uploadLines(const GlFunctions& gl, const GlMesh& mesh, const std::vector<std::array<int, 2>>& lines);
void drawTriangles(const GlFunctions& gl, const GlMesh& mesh);
void drawLines(const GlFunctions& gl, const GlMesh& mesh, LineRange range);

} // namespace toile::picture
