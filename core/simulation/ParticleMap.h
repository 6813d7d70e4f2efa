// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"
#include "core/meshing/GarmentMesh.h"

#include <span>
#include <vector>

namespace toile::simulation {

/// Which particle every mesh node is. Nodes of all pieces are numbered through, in the order of the pieces; nodes
/// that a merged seam made one share a particle.
struct ParticleMap {
    std::vector<int> firstNode;  ///< of each piece
    std::vector<int> particleOf; ///< of each node
    int particleCount = 0;

    [[nodiscard]] int node(meshing::NodeRef ref) const { return firstNode[ref.piece] + ref.node; }
    [[nodiscard]] int particle(meshing::NodeRef ref) const { return particleOf[node(ref)]; }
};

/// One particle per node, but for the seams that are merged. Particles are numbered in the order of their first node.
[[nodiscard]] ParticleMap particleMap(const meshing::GarmentMesh& mesh, const std::vector<bool>& mergedSeams);

/// Where particles are; nodes of one particle are taken at their mean.
[[nodiscard]] std::vector<Vec3> particlePositions(const ParticleMap& map, std::span<const Vec3> nodes);

} // namespace toile::simulation
