// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/body/HalfMesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>

namespace toile::body {

namespace {

using geometry::TriangleIndices;
using geometry::TriangleMesh;

std::uint64_t keyOf(int from, int to) {
    return static_cast<std::uint64_t>(static_cast<std::uint32_t>(from)) << 32 | static_cast<std::uint32_t>(to);
}

int opposite(const TriangleIndices& t, int a, int b) {
    for (const int v : t)
        if (v != a && v != b) return v;
    return -1;
}

double cotangent(const Vec3& at, const Vec3& a, const Vec3& b) {
    const Vec3 u = a - at, v = b - at;
    return dot(u, v) / std::max(length(cross(u, v)), 1e-30);
}

void replace(TriangleIndices& t, int from, int to) {
    std::ranges::replace(t, from, to);
}

/// Flips each inner edge whose opposite angles sum to more than π, once; true if any flipped.
bool flipOnce(TriangleMesh& mesh) {
    std::unordered_map<std::uint64_t, int> triangleOf; // directed edge -> triangle
    triangleOf.reserve(mesh.triangles.size() * 3);
    std::vector<int> valence(mesh.vertices.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            triangleOf[keyOf(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3])] = static_cast<int>(t);
            ++valence[mesh.triangles[t][i]];
        }
    std::vector<char> touched(mesh.triangles.size());
    bool any = false;
    const auto& p = mesh.vertices;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
            if (touched[t] || a > b) continue;
            const auto other = triangleOf.find(keyOf(b, a));
            if (other == triangleOf.end() || touched[other->second]) continue;
            const int c = opposite(mesh.triangles[t], a, b), d = opposite(mesh.triangles[other->second], a, b);
            if (valence[a] <= 4 || valence[b] <= 4 || triangleOf.contains(keyOf(c, d)) ||
                triangleOf.contains(keyOf(d, c)))
                continue;
            if (p[c].x == 0 && p[d].x == 0) continue; // would close over the plane of symmetry
            if (cotangent(p[c], p[a], p[b]) + cotangent(p[d], p[a], p[b]) > -1e-9) continue;
            replace(mesh.triangles[t], b, d);
            replace(mesh.triangles[other->second], a, c);
            touched[t] = touched[other->second] = 1;
            --valence[a], --valence[b], ++valence[c], ++valence[d];
            any = true;
        }
    return any;
}

/// One round of moving every vertex toward the mean of its neighbours in the whole, mirrored mesh.
void moveTowardNeighbours(TriangleMesh& half, double share) {
    std::vector<Vec3> sum(half.vertices.size());
    std::vector<double> weight(half.vertices.size());
    for (const TriangleIndices& t : half.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            for (const std::size_t n : {(i + 1) % 3, (i + 2) % 3}) {
                sum[t[i]] += half.vertices[t[n]];
                weight[t[i]] += 1;
            }
    for (std::size_t v = 0; v < half.vertices.size(); ++v) {
        const bool onPlane = half.vertices[v].x == 0;
        half.vertices[v] = lerp(half.vertices[v], sum[v] / weight[v], share);
        if (onPlane) half.vertices[v].x = 0;
    }
}

} // namespace

void relax(TriangleMesh& half, const std::function<Vec3(const Vec3&)>& ontoSurface, int rounds) {
    for (int round = 0; round < rounds; ++round) {
        moveTowardNeighbours(half, 0.5);
        for (Vec3& p : half.vertices) {
            const bool onPlane = p.x == 0;
            p = ontoSurface(p);
            if (onPlane) p.x = 0;
        }
        for (int flips = 0; flips < 3 && flipOnce(half); ++flips) {
        }
    }
    for (Vec3& p : half.vertices) {
        const bool onPlane = p.x == 0;
        p = ontoSurface(p);
        if (onPlane) p.x = 0;
    }
}

TriangleMesh mirroredWhole(const TriangleMesh& half) {
    TriangleMesh whole = half;
    std::vector<int> mirror(half.vertices.size());
    for (std::size_t v = 0; v < half.vertices.size(); ++v) {
        const Vec3& p = half.vertices[v];
        mirror[v] = p.x == 0 ? static_cast<int>(v) : static_cast<int>(whole.vertices.size());
        if (p.x != 0) whole.vertices.push_back({-p.x, p.y, p.z});
    }
    for (const auto& [a, b, c] : half.triangles) whole.triangles.push_back({mirror[a], mirror[c], mirror[b]});
    return whole;
}

} // namespace toile::body
