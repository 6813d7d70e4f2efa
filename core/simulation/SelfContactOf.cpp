// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SelfContactOf.h"

#include "core/simulation/ParticleMap.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <span>

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
std::vector<RestTriangle> restTriangles(const Garment& garment, const ParticleMap& particles) {
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

/// The edges of the cloth as a graph with lengths, and the last search over it.
class RestGraph {
public:
    RestGraph(const std::vector<RestTriangle>& triangles, int particles)
        : neighbours_(particles), distance_(particles, infinity) {
        for (const RestTriangle& t : triangles)
            for (int k = 0; k < 3; ++k) {
                const int a = t.particles[(k + 1) % 3], b = t.particles[(k + 2) % 3];
                neighbours_[a].emplace_back(b, t.sides[k]);
                neighbours_[b].emplace_back(a, t.sides[k]);
            }
    }

    /// Finds the particles that are not farther than reach from the nearest source along edges.
    void seek(std::span<const int> sources, double reach) {
        for (const int p : reached_) distance_[p] = infinity;
        reached_.clear();
        std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> queue;
        const auto arrive = [&](int particle, double distance) {
            if (distance_[particle] == infinity) reached_.push_back(particle);
            distance_[particle] = distance;
            queue.emplace(distance, particle);
        };
        for (const int source : sources) arrive(source, 0);
        while (!queue.empty()) {
            const auto [distance, at] = queue.top();
            queue.pop();
            if (distance > distance_[at]) continue;
            for (const auto& [next, length] : neighbours_[at])
                if (const double there = distance + length; there <= reach && there < distance_[next])
                    arrive(next, there);
        }
    }
    [[nodiscard]] const std::vector<int>& reached() const { return reached_; }
    [[nodiscard]] double distanceOf(int particle) const { return distance_[particle]; } ///< infinity = not reached [m]

private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<std::vector<std::pair<int, double>>> neighbours_;
    std::vector<double> distance_;
    std::vector<int> reached_;
};

/// For each particle those within reach along the sewn cloth to which open seams are the shorter way: across
/// a seam, and at corners where several meet, across a chain of them.
std::vector<std::vector<int>> broughtNearBySeams(const Garment& garment, const std::vector<RestTriangle>& triangles,
                                                 double reach) {
    constexpr double rounding = 1e-9; // [m]
    if (std::ranges::all_of(garment.mergedSeams, [](bool merged) { return merged; })) return {};
    const ParticleMap sewn = particleMap(*garment.mesh, std::vector<bool>(garment.mergedSeams.size(), true));
    std::vector<int> sewnOf(garment.particles.particleCount);
    std::vector<std::vector<int>> particlesOf(sewn.particleCount);
    for (std::size_t node = 0; node < sewn.particleOf.size(); ++node) {
        const int particle = garment.particles.particleOf[node];
        sewnOf[particle] = sewn.particleOf[node];
        auto& all = particlesOf[sewn.particleOf[node]];
        if (std::ranges::count(all, particle) == 0) all.push_back(particle);
    }
    std::vector<int> atSeam;
    for (std::size_t p = 0; p < sewnOf.size(); ++p)
        if (particlesOf[sewnOf[p]].size() > 1) atSeam.push_back(static_cast<int>(p));

    RestGraph now(triangles, garment.particles.particleCount);
    RestGraph later(restTriangles(garment, sewn), sewn.particleCount);
    std::vector<std::vector<int>> brought(garment.particles.particleCount);
    now.seek(atSeam, reach);
    for (const std::vector<int> nearSeams = now.reached(); const int p : nearSeams) {
        now.seek({&p, 1}, reach);
        later.seek({&sewnOf[p], 1}, reach);
        for (const int near : later.reached())
            for (const int q : particlesOf[near])
                if (now.distanceOf(q) > later.distanceOf(near) + rounding) brought[p].push_back(q);
        std::ranges::sort(brought[p]);
    }
    return brought;
}

double largestSpacing(const meshing::GarmentMesh& mesh) {
    double largest = 0;
    for (const meshing::PieceReport& piece : mesh.report.pieces) largest = std::max(largest, piece.spacing);
    return largest;
}

} // namespace

bool canReachItself(const Garment& garment) {
    const std::vector<RestTriangle> triangles = restTriangles(garment, garment.particles);
    if (triangles.empty()) return false;
    const auto& first = triangles.front().particles;
    std::vector<int> common(first.begin(), first.end()); // corners that all triangles have
    for (const RestTriangle& t : triangles)
        std::erase_if(common, [&](int p) { return std::ranges::count(t.particles, p) == 0; });
    return common.empty() && triangles.size() > 2;
}

dynamics::ClothSurface clothSurfaceOf(const Scene& scene, const Garment& garment) {
    const std::vector<RestTriangle> triangles = restTriangles(garment, garment.particles);
    dynamics::ClothSurface surface;
    const bool layered = std::ranges::any_of(
        scene.pattern.pieces, [&](const auto& piece) { return piece->layer != scene.pattern.pieces.front()->layer; });
    for (const RestTriangle& t : triangles) {
        surface.triangles.push_back(t.particles);
        if (layered) surface.layers.push_back(scene.pattern.pieces[t.piece]->layer);
    }
    surface.halfThickness = garment.halfThickness;
    surface.friction = garment.friction;
    surface.room = roomOf(triangles, garment.particles.particleCount);
    surface.ignored = broughtNearBySeams(garment, triangles, 2 * largestSpacing(*garment.mesh));
    return surface;
}

std::unique_ptr<dynamics::SelfContact> selfContactOf(const Scene& scene, const Garment& garment) {
    return std::make_unique<dynamics::SelfContact>(garment.model, clothSurfaceOf(scene, garment));
}

} // namespace toile::simulation
