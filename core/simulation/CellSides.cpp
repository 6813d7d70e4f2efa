// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/CellSides.h"

#include "core/cloth/Patch.h"
#include "core/pattern/PatternFabrics.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace toile::simulation {
namespace {

double heightOver(const meshing::PieceMesh& mesh, const CellSide& side, int corner) {
    const Vec2 from = mesh.nodes[side.from], along = mesh.nodes[side.to] - from;
    return geometry::cross(along, mesh.nodes[corner] - from) / geometry::length(along);
}

} // namespace

std::vector<material::Fabric> clothsOf(const pattern::Pattern& pattern) {
    std::vector<material::Fabric> cloths;
    for (const auto& piece : pattern.pieces) cloths.push_back(*pattern::clothOf(pattern, *piece));
    return cloths;
}

double bendingAcross(const meshing::PieceMesh& mesh, const CellSide& side, const material::Fabric& cloth) {
    const Vec2 along = mesh.material[side.to] - mesh.material[side.from];
    const Vec2 normal = geometry::leftOf(along);
    return material::bendingStiffness(cloth, std::atan2(-normal.x, normal.y));
}

void appendHinges(cloth::ClothModel& model, const meshing::GarmentMesh& mesh, const ParticleMap& particles,
                  const CellSide& left, const CellSide& right, const Joint& joint) {
    const auto particleOf = [&](const CellSide& side, int node) { return particles.particle({side.piece, node}); };
    const meshing::PieceMesh &leftMesh = mesh.pieces[left.piece], &rightMesh = mesh.pieces[right.piece];
    const std::size_t count = std::max(left.opposite.size(), right.opposite.size());
    for (std::size_t i = 0; i < count; ++i) {
        const int c = left.opposite[std::min(i, left.opposite.size() - 1)];
        // The right side runs the other way, so its corners are met in the other order.
        const int d = right.opposite[right.opposite.size() == 1 ? 0 : 1 - std::min<std::size_t>(i, 1)];
        cloth::SeamEdge edge;
        edge.particles = {particleOf(left, left.from), particleOf(left, left.to), particleOf(left, c),
                          particleOf(right, d)};
        if (std::set<int>(edge.particles.begin(), edge.particles.end()).size() != 4) continue;
        edge.length = geometry::distance(leftMesh.nodes[left.from], leftMesh.nodes[left.to]);
        edge.heightC = heightOver(leftMesh, left, c);
        edge.heightD = heightOver(rightMesh, right, d);
        edge.bending = joint.bending / static_cast<double>(count);
        edge.restAngle = joint.restAngle;
        if (edge.bending > 0) model.hinges.push_back(cloth::seamHinge(edge));
    }
}

} // namespace toile::simulation
