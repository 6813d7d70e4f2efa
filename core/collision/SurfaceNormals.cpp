// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/SurfaceNormals.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <tuple>
#include <unordered_map>

namespace toile::collision {
namespace {

/// For each vertex the first vertex at exactly its position.
std::vector<int> firstAtPosition(const std::vector<Vec3>& vertices) {
    std::vector<int> order(vertices.size()), first(vertices.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](int i) {
        const Vec3& v = vertices[i];
        return std::tuple(v.x, v.y, v.z, i);
    };
    std::ranges::sort(order, {}, key);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool same = k > 0 && vertices[order[k]] == vertices[order[k - 1]];
        first[order[k]] = same ? first[order[k - 1]] : order[k];
    }
    return first;
}

/// Zero for a sliver.
Vec3 faceNormal(const std::array<Vec3, 3>& corner) {
    return isSliver(corner) ? Vec3{} : normalized(cross(corner[1] - corner[0], corner[2] - corner[0]));
}

double angleBetween(const Vec3& a, const Vec3& b) {
    return std::atan2(length(cross(a, b)), dot(a, b));
}

Vec3 unitOrZero(const Vec3& v) {
    const double l = length(v);
    return l > 0 ? v / l : Vec3{};
}

struct EdgeFaces {
    Vec3 normal;
    int forward = 0, backward = 0; ///< faces that run through it from the lower index to the higher, and back
};

std::uint64_t edgeKey(int a, int b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
}

} // namespace

SurfaceNormals::SurfaceNormals(const geometry::TriangleMesh& mesh) : faces_(mesh.triangles.size()) {
    const std::vector<int> first = firstAtPosition(mesh.vertices);
    std::vector<Vec3> cornerSums(mesh.vertices.size());
    std::unordered_map<std::uint64_t, EdgeFaces> edges;
    edges.reserve(mesh.triangles.size() * 2);

    const auto corners = [&](std::size_t f) {
        const auto& t = mesh.triangles[f];
        return std::array{first[t[0]], first[t[1]], first[t[2]]};
    };
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const auto v = corners(f);
        const std::array x{mesh.vertices[v[0]], mesh.vertices[v[1]], mesh.vertices[v[2]]};
        const Vec3 normal = faceNormal(x);
        faces_[f][0] = normal;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
            cornerSums[v[k]] += normal * angleBetween(x[next] - x[k], x[last] - x[k]);
            if (v[k] == v[next]) continue; // the two other edges of a collapsed face are one and cancel
            EdgeFaces& edge = edges[edgeKey(v[k], v[next])];
            edge.normal += normal;
            ++(v[k] < v[next] ? edge.forward : edge.backward);
        }
    }
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const auto v = corners(f);
        for (std::size_t k = 0; k < 3; ++k) {
            if (v[k] != v[(k + 1) % 3]) faces_[f][1 + k] = unitOrZero(edges[edgeKey(v[k], v[(k + 1) % 3])].normal);
            faces_[f][4 + k] = unitOrZero(cornerSums[v[k]]);
        }
    }
    closed_ = !edges.empty() && std::ranges::all_of(edges, [](const auto& entry) {
        return entry.second.forward == entry.second.backward && entry.second.forward == 1;
    });
}

bool isSliver(const std::array<Vec3, 3>& corners) {
    const auto& [a, b, c] = corners;
    const double longest = std::max({squaredLength(b - a), squaredLength(c - b), squaredLength(a - c)});
    // below this height-to-length ratio the regions of closestOnTriangle would be decided by rounding
    return !(length(cross(b - a, c - a)) > 1e-10 * longest);
}

NormalsOnDemand::NormalsOnDemand(const geometry::TriangleMesh& mesh) : firstFace_(mesh.vertices.size() + 1, 0) {
    const std::vector<int> first = firstAtPosition(mesh.vertices);
    faces_.reserve(mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) faces_.push_back({first[a], first[b], first[c]});
    for (const auto& face : faces_)
        for (const int v : face) ++firstFace_[v + 1];
    std::partial_sum(firstFace_.begin(), firstFace_.end(), firstFace_.begin());
    std::vector<int> next(firstFace_.begin(), firstFace_.end() - 1);
    facesAt_.resize(3 * faces_.size());
    for (int f = 0; f < std::ssize(faces_); ++f)
        for (const int v : faces_[f]) facesAt_[next[v]++] = f;
}

std::array<Vec3, 3> NormalsOnDemand::cornersOf(const std::vector<Vec3>& vertices, int face) const {
    const auto& [a, b, c] = faces_[face];
    return {vertices[a], vertices[b], vertices[c]};
}

Vec3 NormalsOnDemand::at(const std::vector<Vec3>& vertices, int triangle, TrianglePart part) const {
    if (part == TrianglePart::inside) return faceNormal(cornersOf(vertices, triangle));
    const auto index = static_cast<std::size_t>(part);
    const bool isEdge = index < 4;
    const int v = faces_[triangle][isEdge ? index - 1 : index - 4];
    const int other = faces_[triangle][isEdge ? index % 3 : index - 4];
    if (isEdge && v == other) return {};
    Vec3 sum;
    for (const int f : std::span(facesAt_).subspan(firstFace_[v], firstFace_[v + 1] - firstFace_[v])) {
        const std::array<Vec3, 3> x = cornersOf(vertices, f);
        for (std::size_t k = 0; k < 3; ++k) {
            const int here = faces_[f][k], next = faces_[f][(k + 1) % 3], last = faces_[f][(k + 2) % 3];
            if (here != v) continue;
            if (!isEdge) sum += faceNormal(x) * angleBetween(x[(k + 1) % 3] - x[k], x[(k + 2) % 3] - x[k]);
            else if (next == other || last == other) sum += faceNormal(x);
        }
    }
    return unitOrZero(sum);
}

std::size_t NormalsOnDemand::bytes() const {
    return faces_.capacity() * sizeof(faces_[0]) + (firstFace_.capacity() + facesAt_.capacity()) * sizeof(int);
}

} // namespace toile::collision
