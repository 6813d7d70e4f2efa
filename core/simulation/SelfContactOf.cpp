// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SelfContactOf.h"

#include <algorithm>
#include <limits>

namespace toile::simulation {
namespace {

/// A triangle of the cloth with the lengths of its sides at rest: sides[k] lies across from corners[k] [m].
struct RestTriangle {
    std::array<int, 3> particles;
    std::array<double, 3> sides;
    double area; ///< [m²]
    std::size_t piece;
};

/// Merging may leave a triangle with two corners on one particle; it has no area then and is left out.
std::vector<RestTriangle> restTriangles(const Garment& garment) {
    const ParticleMap& particles = garment.particles;
    std::vector<RestTriangle> triangles;
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece) {
        const meshing::PieceMesh& mesh = garment.mesh->pieces[piece];
        for (const auto& corners : mesh.display) {
            RestTriangle t{.piece = piece};
            for (int k = 0; k < 3; ++k) {
                t.particles[k] = particles.particleOf[particles.firstNode[piece] + corners[k]];
                t.sides[k] = geometry::distance(mesh.nodes[corners[(k + 1) % 3]], mesh.nodes[corners[(k + 2) % 3]]);
            }
            t.area = 0.5 * std::abs(geometry::cross(mesh.nodes[corners[1]] - mesh.nodes[corners[0]],
                                                    mesh.nodes[corners[2]] - mesh.nodes[corners[0]]));
            const auto& [a, b, c] = t.particles;
            if (a != b && b != c && c != a) triangles.push_back(t);
        }
    }
    return triangles;
}

/// For each particle the least height of its triangles over the side across: nothing that does not end in it
/// is nearer.
std::vector<double> roomOf(const std::vector<RestTriangle>& triangles, int particles) {
    std::vector<double> room(particles, std::numeric_limits<double>::infinity());
    for (const RestTriangle& t : triangles)
        for (int k = 0; k < 3; ++k) room[t.particles[k]] = std::min(room[t.particles[k]], 2 * t.area / t.sides[k]);
    return room;
}

} // namespace

bool canReachItself(const Garment& garment) {
    const std::vector<RestTriangle> triangles = restTriangles(garment);
    if (triangles.empty()) return false;
    const auto& first = triangles.front().particles;
    std::vector<int> common(first.begin(), first.end()); // corners that all triangles have
    for (const RestTriangle& t : triangles)
        std::erase_if(common, [&](int p) { return std::ranges::count(t.particles, p) == 0; });
    return common.empty() && triangles.size() > 2;
}

dynamics::ClothSurface clothSurfaceOf(const Scene& scene, const Garment& garment, std::span<const PiecePair> passing) {
    const std::vector<RestTriangle> triangles = restTriangles(garment);
    dynamics::ClothSurface surface;
    const bool layered = std::ranges::any_of(
        scene.pattern.pieces, [&](const auto& piece) { return piece->layer != scene.pattern.pieces.front()->layer; });
    for (const RestTriangle& t : triangles) {
        surface.triangles.push_back(t.particles);
        if (layered) surface.layers.push_back(scene.pattern.pieces[t.piece]->layer);
        if (!passing.empty()) surface.pieces.push_back(static_cast<int>(t.piece));
    }
    surface.halfThickness = garment.halfThickness;
    surface.friction = garment.friction;
    surface.room = roomOf(triangles, garment.particles.particleCount);
    surface.becomes = whatBecomesOf(garment);
    surface.passing.assign(passing.begin(), passing.end());
    return surface;
}

std::unique_ptr<dynamics::SelfContact> selfContactOf(const Scene& scene, const Garment& garment,
                                                     std::span<const PiecePair> passing) {
    return std::make_unique<dynamics::SelfContact>(garment.model, clothSurfaceOf(scene, garment, passing));
}

} // namespace toile::simulation
