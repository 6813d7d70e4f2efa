// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/TriangleMesh.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>
#include <unordered_map>

namespace toile::geometry {

double signedVolume(const TriangleMesh& mesh) {
    double sixfold = 0;
    for (const auto& [a, b, c] : mesh.triangles)
        sixfold += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c]));
    return sixfold / 6;
}

bool isClosedManifold(const TriangleMesh& mesh) {
    std::unordered_map<std::uint64_t, int> uses; // directed edge -> how often
    const auto key = [](int from, int to) {
        return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32 | static_cast<std::uint32_t>(to);
    };
    for (const TriangleIndices& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (++uses[key(t[i], t[(i + 1) % 3])] > 1) return false;
    return !uses.empty() && std::ranges::all_of(uses, [&](const auto& use) {
        const auto from = static_cast<int>(use.first >> 32), to = static_cast<int>(use.first & 0xffffffffu);
        return uses.contains(key(to, from));
    });
}

std::vector<Vec3> vertexNormals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals(mesh.vertices.size());
    for (const TriangleIndices& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 doubledArea = cross(b - a, c - a);
        for (const int corner : t) normals[corner] += doubledArea;
    }
    for (Vec3& n : normals)
        if (const double l = length(n); l > 0) n = n / l;
    return normals;
}

TriangleMesh welded(const TriangleMesh& mesh, double tolerance) {
    using Cell = std::tuple<long long, long long, long long>;
    std::map<Cell, std::vector<int>> grid;
    const auto cellOf = [&](const Vec3& p) {
        const auto at = [&](double x) { return static_cast<long long>(std::floor(x / tolerance)); };
        return Cell{at(p.x), at(p.y), at(p.z)};
    };
    TriangleMesh result;
    std::vector<int> target;
    target.reserve(mesh.vertices.size());
    for (const Vec3& p : mesh.vertices) {
        const auto [cx, cy, cz] = cellOf(p);
        int found = -1;
        for (long long x = cx - 1; x <= cx + 1 && found < 0; ++x)
            for (long long y = cy - 1; y <= cy + 1 && found < 0; ++y)
                for (long long z = cz - 1; z <= cz + 1 && found < 0; ++z)
                    if (const auto cell = grid.find({x, y, z}); cell != grid.end())
                        for (const int candidate : cell->second)
                            if (distance(result.vertices[candidate], p) < tolerance) {
                                found = candidate;
                                break;
                            }
        if (found < 0) {
            found = static_cast<int>(result.vertices.size());
            result.vertices.push_back(p);
            grid[{cx, cy, cz}].push_back(found);
        }
        target.push_back(found);
    }
    for (const TriangleIndices& t : mesh.triangles) {
        const TriangleIndices mapped{target[t[0]], target[t[1]], target[t[2]]};
        if (mapped[0] != mapped[1] && mapped[1] != mapped[2] && mapped[2] != mapped[0])
            result.triangles.push_back(mapped);
    }
    return result;
}

Box3 boundsOf(const std::vector<Vec3>& points) {
    if (points.empty()) return {};
    Box3 box{points.front(), points.front()};
    for (const Vec3& p : points)
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = std::min(box.low[axis], p[axis]);
            box.high[axis] = std::max(box.high[axis], p[axis]);
        }
    return box;
}

} // namespace toile::geometry
