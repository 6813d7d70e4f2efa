// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/picture/GlMesh.h"

#include <cstddef>

namespace toile::picture {

namespace {

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(bytes);
}

void attribute(const GlFunctions& gl, GLuint location, GLint size, std::size_t at) {
    gl.EnableVertexAttribArray(location);
    gl.VertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(SurfaceVertex), offset(at));
}

template <class Index>
void fillIndices(const GlFunctions& gl, GLuint array, const std::vector<Index>& indices) {
    gl.BindVertexArray(array); // the index buffer is bound to it
    gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices.size() * sizeof(Index)), indices.data(),
                  GL_STATIC_DRAW);
    gl.BindVertexArray(0);
}

} // namespace

GlMesh createMesh(const GlFunctions& gl) {
    GlMesh mesh;
    gl.GenVertexArrays(1, &mesh.vertexArray);
    gl.GenVertexArrays(1, &mesh.lineArray);
    gl.GenBuffers(1, &mesh.vertices);
    gl.GenBuffers(1, &mesh.triangles);
    gl.GenBuffers(1, &mesh.lines);
    gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices);
    gl.BindVertexArray(mesh.vertexArray);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
    attribute(gl, 0, 3, offsetof(SurfaceVertex, position));
    attribute(gl, 1, 3, offsetof(SurfaceVertex, normal));
    attribute(gl, 2, 1, offsetof(SurfaceVertex, cavity));
    gl.BindVertexArray(mesh.lineArray);
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.lines);
    attribute(gl, 0, 3, offsetof(SurfaceVertex, position));
    gl.BindVertexArray(0);
    return mesh;
}

void deleteMesh(const GlFunctions& gl, const GlMesh& mesh) {
    gl.DeleteVertexArrays(1, &mesh.vertexArray);
    gl.DeleteVertexArrays(1, &mesh.lineArray);
    gl.DeleteBuffers(1, &mesh.vertices);
    gl.DeleteBuffers(1, &mesh.triangles);
    gl.DeleteBuffers(1, &mesh.lines);
}

void uploadVertices(const GlFunctions& gl, const GlMesh& mesh, const std::vector<SurfaceVertex>& vertices) {
    gl.BindBuffer(GL_ARRAY_BUFFER, mesh.vertices);
    gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(SurfaceVertex)), vertices.data(),
                  GL_STREAM_DRAW);
}

void uploadTriangles(const GlFunctions& gl, GlMesh& mesh, const std::vector<geometry::TriangleIndices>& triangles) {
    fillIndices(gl, mesh.vertexArray, triangles);
    mesh.triangleIndices = static_cast<GLsizei>(triangles.size() * 3);
}

void uploadLines(const GlFunctions& gl, const GlMesh& mesh, const std::vector<std::array<int, 2>>& lines) {
    fillIndices(gl, mesh.lineArray, lines);
}

void drawTriangles(const GlFunctions& gl, const GlMesh& mesh) {
    gl.BindVertexArray(mesh.vertexArray);
    gl.DrawElements(GL_TRIANGLES, mesh.triangleIndices, GL_UNSIGNED_INT, nullptr);
}

void drawLines(const GlFunctions& gl, const GlMesh& mesh, LineRange range) {
    if (range.count == 0) return;
    gl.BindVertexArray(mesh.lineArray);
    gl.DrawElements(GL_LINES, range.count, GL_UNSIGNED_INT,
                    offset(static_cast<std::size_t>(range.first) * sizeof(GLuint)));
}

} // namespace toile::picture
