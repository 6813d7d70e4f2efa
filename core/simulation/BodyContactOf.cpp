// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/BodyContactOf.h"

#include "core/dynamics/BodyContact.h"

#include <algorithm>
#include <cmath>

namespace toile::simulation {
namespace {

/// Cells smaller than this follow every limb by their corners: a chord of 15 mm over a radius of 30 mm dips in by
/// 15²/(8·30) = 0.9 mm, less than a third of the skin offset.
constexpr double followingSize = 0.015; // [m]

double longestSide(const meshing::PieceMesh& mesh, std::span<const int> corners) {
    double longest = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = i + 1; k < corners.size(); ++k)
            longest = std::max(longest, geometry::distance(mesh.nodes[corners[i]], mesh.nodes[corners[k]]));
    return longest;
}

void appendMiddles(std::vector<dynamics::ContactSample>& samples, const Garment& garment) {
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece) {
        const meshing::PieceMesh& mesh = garment.mesh->pieces[piece];
        const int first = garment.particles.firstNode[piece];
        const auto append = [&](std::span<const int> corners) {
            if (longestSide(mesh, corners) <= followingSize) return;
            std::vector<const dynamics::ContactSample*> ends;
            for (const int node : corners) ends.push_back(&samples[garment.particles.particleOf[first + node]]);
            dynamics::ContactSample middle = dynamics::middleOf(ends);
            samples.push_back(std::move(middle)); // only now may the corners move
        };
        for (const meshing::Rectangle& cell : mesh.rectangles) append(cell.nodes);
        for (const meshing::Triangle& t : mesh.triangles) append(t.nodes);
    }
}

} // namespace

std::unique_ptr<dynamics::Stage> bodyContactOf(const Scene& scene, const Garment& garment, const collision::BodySurface& body) {
    std::vector<dynamics::ContactSample> samples = dynamics::particleSamples(
        garment.model, garment.halfThickness, garment.friction, scene.settings.bodyFriction);
    appendMiddles(samples, garment);
    return std::make_unique<dynamics::BodyContact>(body, std::move(samples),
                                                   dynamics::BodyContactSettings{.skinOffset = scene.settings.skinOffset});
}

} // namespace toile::simulation
