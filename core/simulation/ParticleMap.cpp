// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/ParticleMap.h"

#include "core/base/Contracts.h"
#include "core/base/UnionFind.h"

namespace toile::simulation {

ParticleMap particleMap(const meshing::GarmentMesh& mesh, const std::vector<bool>& mergedSeams) {
    expects(mergedSeams.size() == mesh.seams.size(), "one flag per seam");
    ParticleMap map;
    int nodes = 0;
    for (const meshing::PieceMesh& piece : mesh.pieces) {
        map.firstNode.push_back(nodes);
        nodes += static_cast<int>(piece.nodes.size());
    }
    UnionFind classes(nodes);
    for (std::size_t seam = 0; seam < mesh.seams.size(); ++seam)
        if (mergedSeams[seam])
            for (const auto& [a, b] : mesh.seams[seam].pairs) classes.join(map.node(a), map.node(b));

    map.particleOf.assign(nodes, -1);
    for (int node = 0; node < nodes; ++node) {
        const int root = classes.rootOf(node); // never after the node itself
        map.particleOf[node] = root == node ? map.particleCount++ : map.particleOf[root];
    }
    return map;
}

std::vector<Vec3> particlePositions(const ParticleMap& map, std::span<const Vec3> nodes) {
    std::vector<Vec3> sum(map.particleCount);
    std::vector<int> count(map.particleCount, 0);
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        sum[map.particleOf[node]] += nodes[node];
        ++count[map.particleOf[node]];
    }
    for (int particle = 0; particle < map.particleCount; ++particle) sum[particle] = sum[particle] / count[particle];
    return sum;
}

} // namespace toile::simulation
