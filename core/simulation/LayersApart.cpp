// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/LayersApart.h"

#include "core/collision/BodySurface.h"
#include "core/pattern/PatternPlacement.h"
#include "core/simulation/Topology.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <tuple>

namespace toile::simulation {
namespace {

struct PlacedPiece {
    const meshing::PieceMesh& mesh;
    std::span<const Vec3> positions;
    int layer;
};

std::vector<PlacedPiece> piecesOf(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                                  std::span<const Vec3> nodes) {
    std::vector<PlacedPiece> pieces;
    std::size_t first = 0;
    for (std::size_t i = 0; i < mesh.pieces.size(); ++i) {
        const std::size_t count = mesh.pieces[i].nodes.size();
        pieces.push_back({mesh.pieces[i], nodes.subspan(first, count), pattern.pieces[i]->layer});
        first += count;
    }
    return pieces;
}

/// The right sides of all pieces below a layer; none if there are none.
std::optional<collision::BodySurface> surfaceBelow(int layer, const std::vector<PlacedPiece>& pieces) {
    geometry::TriangleMesh below;
    for (const PlacedPiece& piece : pieces) {
        if (piece.layer >= layer) continue;
        const int first = static_cast<int>(below.vertices.size());
        below.vertices.insert(below.vertices.end(), piece.positions.begin(), piece.positions.end());
        for (const auto& [a, b, c] : piece.mesh.display) below.triangles.push_back({first + a, first + b, first + c});
    }
    auto surface = collision::BodySurface::create(std::move(below)); // refuses to be made of nothing
    if (!surface) return std::nullopt;
    return std::move(*surface);
}

/// Normal of the piece at each of its nodes, on the right side; not of unit length.
std::vector<Vec3> normalsOf(const PlacedPiece& piece) {
    std::vector<Vec3> normals(piece.positions.size());
    for (const auto& corners : piece.mesh.display) {
        const auto& x = piece.positions;
        const Vec3 normal = cross(x[corners[1]] - x[corners[0]], x[corners[2]] - x[corners[0]]);
        for (const int corner : corners) normals[corner] += normal;
    }
    return normals;
}

/// How far outside the surface a point lies that is over it or under it [m]. Nothing where it is farther off than
/// `reach`, beside the surface's border, or over a surface that faces the other way, as a back does from a front.
std::optional<double> heightOver(const collision::BodySurface& surface, const Vec3& point, const Vec3& normal,
                                 double reach) {
    constexpr double steepest = 0.7; // of the way along the normal
    const auto nearest = surface.nearest(point, reach);
    if (!nearest) return std::nullopt;
    const auto& [vertices, triangles] = surface.mesh();
    const auto& [a, b, c] = triangles[nearest->triangle];
    const Vec3 outward = normalized(cross(vertices[b] - vertices[a], vertices[c] - vertices[a]));
    if (dot(outward, normal) <= 0) return std::nullopt;
    const Vec3 way = point - nearest->point;
    const double height = dot(way, outward), far = length(way);
    if (far > 0 && std::abs(height) < steepest * far) return std::nullopt;
    return height;
}

/// Where the piece has nodes in common with a surface: there cloth goes over into other cloth, and may fold either way.
std::vector<Vec3> whereSewnTo(const collision::BodySurface& surface, const PlacedPiece& piece) {
    const auto isLess = [](const Vec3& a, const Vec3& b) {
        return std::tuple(a.x, a.y, a.z) < std::tuple(b.x, b.y, b.z);
    };
    const std::set<Vec3, decltype(isLess)> other(surface.mesh().vertices.begin(), surface.mesh().vertices.end());
    std::vector<Vec3> common;
    std::ranges::copy_if(piece.positions, std::back_inserter(common), [&](const Vec3& p) { return other.contains(p); });
    return common;
}

bool isOutside(const PlacedPiece& piece, const collision::BodySurface& below) {
    constexpr double clearance = 0.005, reach = 0.06; // [m]
    const std::vector<Vec3> normals = normalsOf(piece);
    for (std::size_t node = 0; node < normals.size(); ++node) {
        const auto height = heightOver(below, piece.positions[node], normals[node], reach);
        if (height && *height < clearance) return false;
    }
    return true;
}

/// As it was if 10 cm do not help.
pattern::Placement movedOutside(const PlacedPiece& piece, const pattern::Placement& placement,
                                const collision::BodySurface& below) {
    constexpr double step = 0.0025, farthest = 0.1; // [m]
    for (double way = 0; way <= farthest; way += step) {
        const pattern::Placement moved = pattern::movedOutward(placement, way);
        std::vector<Vec3> positions;
        for (const Vec2 node : piece.mesh.nodes) positions.push_back(pattern::placed(moved, node));
        if (isOutside({piece.mesh, positions, piece.layer}, below)) return moved;
    }
    return placement;
}

std::set<int> layersOf(const pattern::Pattern& pattern) {
    std::set<int> layers;
    for (const auto& piece : pattern.pieces) layers.insert(piece->layer);
    return layers;
}

} // namespace

pattern::Pattern layersApart(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh) {
    const std::set<int> layers = layersOf(pattern);
    pattern::Pattern apart = pattern;
    if (layers.size() < 2) return apart;
    for (const int layer : layers) { // from the inside out: each lies over those that have been moved
        const std::vector<Vec3> nodes = placedNodes(apart, mesh);
        const std::vector<PlacedPiece> pieces = piecesOf(apart, mesh, nodes);
        const auto below = surfaceBelow(layer, pieces);
        if (!below) continue;
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            if (pieces[i].layer != layer) continue;
            pattern::Piece piece = *apart.pieces[i];
            piece.placement = movedOutside(pieces[i], piece.placement.value_or(pattern::Placement{}), *below);
            apart.pieces[i] = std::move(piece);
        }
    }
    return apart;
}

int nodesInWrongOrder(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh, std::span<const Vec3> nodes) {
    constexpr double reach = 0.02; // [m]
    const std::vector<PlacedPiece> pieces = piecesOf(pattern, mesh, nodes);
    int wrong = 0;
    for (const int layer : layersOf(pattern)) {
        const auto below = surfaceBelow(layer, pieces);
        if (!below) continue;
        for (const PlacedPiece& piece : pieces) {
            if (piece.layer != layer) continue;
            const std::vector<Vec3> normals = normalsOf(piece), seams = whereSewnTo(*below, piece);
            for (std::size_t node = 0; node < normals.size(); ++node) {
                const Vec3& at = piece.positions[node];
                const auto height = heightOver(*below, at, normals[node], reach);
                const auto isNear = [&](const Vec3& seam) { return geometry::distance(seam, at) < reach; };
                wrong += height && *height < 0 && std::ranges::none_of(seams, isNear);
            }
        }
    }
    return wrong;
}

} // namespace toile::simulation
