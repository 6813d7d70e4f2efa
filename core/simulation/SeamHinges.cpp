// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SeamHinges.h"

#include "core/cloth/Patch.h"
#include "core/pattern/PatternFabrics.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace toile::simulation {
namespace {

/// An edge that only one element of its piece has, run through counter-clockwise, with the element's other corners.
struct BorderEdge {
    int piece = 0;
    int from = 0, to = 0;      ///< nodes of the piece
    std::vector<int> opposite; ///< one for a triangle; for a rectangle the neighbour of from, then that of to
};

std::vector<BorderEdge> borderEdges(const meshing::PieceMesh& mesh, int piece) {
    std::map<std::array<int, 2>, BorderEdge> open;
    const auto meet = [&](int from, int to, std::vector<int> opposite) {
        if (open.erase({to, from}) == 0) open[{from, to}] = {piece, from, to, std::move(opposite)};
    };
    for (const meshing::Rectangle& cell : mesh.rectangles)
        for (std::size_t i = 0; i < 4; ++i)
            meet(cell.nodes[i], cell.nodes[(i + 1) % 4], {cell.nodes[(i + 3) % 4], cell.nodes[(i + 2) % 4]});
    for (const meshing::Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) meet(t.nodes[i], t.nodes[(i + 1) % 3], {t.nodes[(i + 2) % 3]});
    std::vector<BorderEdge> edges;
    for (auto& [ends, edge] : open) edges.push_back(std::move(edge));
    return edges;
}

/// For every node of the garment the merged seams that it is in.
std::vector<std::vector<int>> seamsOfNodes(const meshing::GarmentMesh& mesh, const std::vector<bool>& merged,
                                           const ParticleMap& particles) {
    std::vector<std::vector<int>> seams(particles.particleOf.size());
    for (std::size_t seam = 0; seam < mesh.seams.size(); ++seam) {
        if (!merged[seam]) continue;
        for (const auto& pair : mesh.seams[seam].pairs)
            for (const meshing::NodeRef& ref : pair) seams[particles.node(ref)].push_back(static_cast<int>(seam));
    }
    return seams;
}

double heightOver(const meshing::PieceMesh& mesh, const BorderEdge& edge, int corner) {
    const Vec2 from = mesh.nodes[edge.from], along = mesh.nodes[edge.to] - from;
    return geometry::cross(along, mesh.nodes[corner] - from) / geometry::length(along);
}

/// Bending stiffness for a fold along the edge.
double bendingAcross(const meshing::PieceMesh& mesh, const BorderEdge& edge, const material::Fabric& fabric) {
    const Vec2 along = mesh.material[edge.to] - mesh.material[edge.from];
    const Vec2 normal = geometry::leftOf(along);
    return material::bendingStiffness(fabric, std::atan2(-normal.x, normal.y));
}

} // namespace

void appendSeamHinges(cloth::ClothModel& model, const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                      const std::vector<bool>& mergedSeams, const ParticleMap& particles) {
    if (std::ranges::none_of(mergedSeams, [](bool merged) { return merged; })) return;
    const std::vector<std::vector<int>> seamsOf = seamsOfNodes(mesh, mergedSeams, particles);
    const auto nodeOf = [&](const BorderEdge& e, int node) { return particles.firstNode[e.piece] + node; };
    const auto particleOf = [&](const BorderEdge& e, int node) { return particles.particleOf[nodeOf(e, node)]; };

    std::vector<material::Fabric> cloths;
    for (const auto& piece : pattern.pieces) cloths.push_back(*pattern::clothOf(pattern, *piece));

    std::map<std::array<int, 2>, std::vector<BorderEdge>> byParticles;
    for (std::size_t piece = 0; piece < mesh.pieces.size(); ++piece)
        for (BorderEdge& edge : borderEdges(mesh.pieces[piece], static_cast<int>(piece))) {
            const int a = particleOf(edge, edge.from), b = particleOf(edge, edge.to);
            byParticles[{std::min(a, b), std::max(a, b)}].push_back(std::move(edge));
        }

    for (const auto& [ends, edges] : byParticles) {
        if (edges.size() != 2) continue;
        const BorderEdge &left = edges[0], &right = edges[1];
        const int a = particleOf(left, left.from), b = particleOf(left, left.to);
        if (particleOf(right, right.from) != b || particleOf(right, right.to) != a) continue;
        const auto& candidates = seamsOf[nodeOf(left, left.from)];
        const auto seam = std::ranges::find_if(
            candidates, [&](int s) { return std::ranges::count(seamsOf[nodeOf(left, left.to)], s) > 0; });
        if (seam == candidates.end()) continue;

        const meshing::PieceMesh &leftMesh = mesh.pieces[left.piece], &rightMesh = mesh.pieces[right.piece];
        const double bending =
            pattern.seams[*seam].stiffnessFactor * 0.5 *
            (bendingAcross(leftMesh, left, cloths[left.piece]) + bendingAcross(rightMesh, right, cloths[right.piece]));
        // A rectangle has two opposite corners: two hinges share its stiffness, each with the corner at its own end.
        const std::size_t count = std::max(left.opposite.size(), right.opposite.size());
        for (std::size_t i = 0; i < count; ++i) {
            const int c = left.opposite[std::min(i, left.opposite.size() - 1)];
            // The right edge runs the other way, so its corners are met in the other order.
            const int d = right.opposite[right.opposite.size() == 1 ? 0 : 1 - std::min<std::size_t>(i, 1)];
            cloth::SeamEdge joint;
            joint.particles = {a, b, particleOf(left, c), particleOf(right, d)};
            if (std::set<int>(joint.particles.begin(), joint.particles.end()).size() != 4) continue;
            joint.length = geometry::distance(leftMesh.nodes[left.from], leftMesh.nodes[left.to]);
            joint.heightC = heightOver(leftMesh, left, c);
            joint.heightD = heightOver(rightMesh, right, d);
            joint.bending = bending / static_cast<double>(count);
            joint.restAngle = pattern.seams[*seam].foldAngle;
            if (joint.bending > 0) model.hinges.push_back(cloth::seamHinge(joint));
        }
    }
}

} // namespace toile::simulation
