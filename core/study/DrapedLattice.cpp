// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/DrapedLattice.h"

#include "core/base/Contracts.h"
#include "core/simulation/CarryOver.h"

#include <algorithm>
#include <cmath>

namespace toile::study {
namespace {

/// Of the corners of a piece: the same in all layouts.
geometry::Box2 extentOf(const pattern::Pattern& pattern, std::size_t piece) {
    std::vector<Vec2> corners;
    for (const auto& vertex : pattern::resolved(pattern, *pattern.pieces[piece]).outline.vertices)
        corners.push_back(vertex.position);
    return geometry::boundsOf(corners);
}

} // namespace

DrapedLattice latticeOf(const simulation::Simulation& simulation) {
    constexpr int across = 33;
    const std::vector<Vec3> nodes = simulation.nodePositions();
    const auto& garment = simulation.garment();
    DrapedLattice lattice;
    for (std::size_t piece = 0; piece < garment.mesh->pieces.size(); ++piece) {
        const meshing::PieceMesh& mesh = garment.mesh->pieces[piece];
        const simulation::DrapedPiece drape(
            mesh, std::span(nodes).subspan(garment.particles.firstNode[piece], mesh.nodes.size()));
        const auto [low, high] = extentOf(simulation.scene().pattern, piece);
        for (int j = 0; j < across; ++j)
            for (int i = 0; i < across; ++i)
                lattice.push_back(drape.inside(
                    {std::lerp(low.x, high.x, (i + 0.5) / across), std::lerp(low.y, high.y, (j + 0.5) / across)}));
    }
    return lattice;
}

LatticeDifference differenceOf(const DrapedLattice& a, const DrapedLattice& b) {
    expects(a.size() == b.size(), "the same lattice");
    LatticeDifference difference;
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!a[i] || !b[i]) continue;
        const double d = geometry::distance(*a[i], *b[i]);
        sum += d * d;
        difference.maximum = std::max(difference.maximum, d);
        ++difference.points;
    }
    if (difference.points > 0) difference.rms = std::sqrt(sum / difference.points);
    return difference;
}

} // namespace toile::study
