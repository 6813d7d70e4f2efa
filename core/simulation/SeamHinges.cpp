// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SeamHinges.h"

#include "core/simulation/CellSides.h"

#include <algorithm>
#include <map>

namespace toile::simulation {
namespace {

/// The sides that only one element of a piece has.
std::vector<CellSide> borderSides(const meshing::PieceMesh& mesh, int piece) {
    std::map<std::array<int, 2>, CellSide> open;
    forEachSide(mesh, piece, [&](CellSide side) {
        if (open.erase({side.to, side.from}) == 0) open[{side.from, side.to}] = std::move(side);
    });
    std::vector<CellSide> sides;
    for (auto& [ends, side] : open) sides.push_back(std::move(side));
    return sides;
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

} // namespace

void appendSeamHinges(cloth::ClothModel& model, const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                      const std::vector<bool>& mergedSeams, const ParticleMap& particles) {
    if (std::ranges::none_of(mergedSeams, [](bool merged) { return merged; })) return;
    const std::vector<std::vector<int>> seamsOf = seamsOfNodes(mesh, mergedSeams, particles);
    const auto nodeOf = [&](const CellSide& side, int node) { return particles.firstNode[side.piece] + node; };
    const auto particleOf = [&](const CellSide& side, int node) { return particles.particleOf[nodeOf(side, node)]; };
    const std::vector<material::Fabric> cloths = clothsOf(pattern);

    std::map<std::array<int, 2>, std::vector<CellSide>> byParticles;
    for (std::size_t piece = 0; piece < mesh.pieces.size(); ++piece)
        for (CellSide& side : borderSides(mesh.pieces[piece], static_cast<int>(piece))) {
            const int a = particleOf(side, side.from), b = particleOf(side, side.to);
            byParticles[{std::min(a, b), std::max(a, b)}].push_back(std::move(side));
        }

    for (const auto& [ends, sides] : byParticles) {
        if (sides.size() != 2) continue;
        const CellSide &left = sides[0], &right = sides[1];
        if (particleOf(right, right.from) != particleOf(left, left.to) ||
            particleOf(right, right.to) != particleOf(left, left.from))
            continue;
        const auto& candidates = seamsOf[nodeOf(left, left.from)];
        const auto seam = std::ranges::find_if(
            candidates, [&](int s) { return std::ranges::count(seamsOf[nodeOf(left, left.to)], s) > 0; });
        if (seam == candidates.end()) continue;
        const double bending = pattern.seams[*seam].stiffnessFactor * 0.5 *
                               (bendingAcross(mesh.pieces[left.piece], left, cloths[left.piece]) +
                                bendingAcross(mesh.pieces[right.piece], right, cloths[right.piece]));
        appendHinges(model, mesh, particles, left, right, {bending, pattern.seams[*seam].foldAngle});
    }
}

} // namespace toile::simulation
