// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/Bumps.h"

#include <utility>

namespace toile::collision {

std::vector<int> bumpsOf(const geometry::TriangleMesh& mesh, double radius) {
    const std::size_t count = mesh.vertices.size();
    std::vector<Vec3> normals(count);
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 doubledArea = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
        for (const int corner : {a, b, c}) normals[corner] += doubledArea;
    }
    // The curvature along an edge of length d is twice the way that its far end lies below the tangent plane,
    // over d².
    std::vector<double> curvature(count, 0);
    std::vector<int> edges(count, 0);
    const auto look = [&](int from, int to) {
        const Vec3 edge = mesh.vertices[to] - mesh.vertices[from];
        const double size = length(normals[from]), squared = squaredLength(edge);
        if (size == 0 || squared == 0) return;
        curvature[from] -= 2 * dot(edge, normals[from]) / (size * squared);
        ++edges[from];
    };
    for (const auto& [a, b, c] : mesh.triangles) // each edge of a closed mesh is seen from both faces alike
        for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}}) look(from, to);
    std::vector<int> bumps;
    for (std::size_t i = 0; i < count; ++i)
        if (edges[i] > 0 && curvature[i] / edges[i] > 1 / radius) bumps.push_back(static_cast<int>(i));
    return bumps;
}

} // namespace toile::collision
