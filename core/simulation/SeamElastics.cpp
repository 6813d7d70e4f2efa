// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SeamElastics.h"

#include <algorithm>
#include <limits>

namespace toile::simulation {
namespace {

using Pair = std::array<meshing::NodeRef, 2>;

constexpr double endless = std::numeric_limits<double>::infinity();

/// Of the cloth between two neighbouring pairs [m]; endless where each side goes on in another piece.
double sewnLength(const meshing::GarmentMesh& mesh, const Pair& from, const Pair& to) {
    double shorter = endless;
    for (const int side : {0, 1}) {
        if (from[side].piece != to[side].piece) continue;
        const auto& material = mesh.pieces[to[side].piece].material;
        shorter = std::min(shorter, geometry::distance(material[from[side].node], material[to[side].node]));
    }
    return shorter;
}

} // namespace

void appendSeamElastics(cloth::ClothModel& model, const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                        const std::vector<bool>& mergedSeams, const ParticleMap& particles) {
    for (std::size_t seam = 0; seam < mergedSeams.size(); ++seam) {
        const auto& elastic = pattern.seams[seam].elastic;
        if (!mergedSeams[seam] || !elastic) continue;
        const auto& pairs = mesh.seams[seam].pairs;
        for (std::size_t stitch = 1; stitch < pairs.size(); ++stitch) {
            const int a = particles.particle(pairs[stitch - 1][0]), b = particles.particle(pairs[stitch][0]);
            const double length = sewnLength(mesh, pairs[stitch - 1], pairs[stitch]);
            if (a == b || length == endless) continue; // a joint of two pieces
            const double rest = elastic->ratio * length;
            model.elastics.push_back({a, b, rest, elastic->stiffness / rest});
        }
    }
}

} // namespace toile::simulation
