// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/FoldHinges.h"

#include "core/cloth/FoldAngle.h"
#include "core/simulation/CellSides.h"

#include <algorithm>
#include <array>
#include <map>

namespace toile::simulation {
namespace {

/// The sides of elements along the folds of a piece, by their nodes in the order they are run through.
std::map<std::array<int, 2>, CellSide> foldSides(const meshing::PieceMesh& mesh, int piece) {
    std::vector<char> isOnFold(mesh.nodes.size(), 0);
    for (const auto& fold : mesh.folds)
        for (const int node : fold) isOnFold[node] = 1;
    std::map<std::array<int, 2>, CellSide> sides;
    forEachSide(mesh, piece, [&](CellSide side) {
        if (isOnFold[side.from] && isOnFold[side.to]) sides.emplace(std::array{side.from, side.to}, std::move(side));
    });
    return sides;
}

} // namespace

std::vector<FoldHinges> appendFoldHinges(cloth::ClothModel& model, const pattern::Pattern& pattern,
                                         const meshing::GarmentMesh& mesh, const ParticleMap& particles) {
    std::vector<FoldHinges> all;
    if (std::ranges::all_of(mesh.pieces, [](const auto& piece) { return piece.folds.empty(); })) return all;
    const std::vector<material::Fabric> cloths = clothsOf(pattern);
    for (int piece = 0; piece < std::ssize(mesh.pieces); ++piece) {
        const meshing::PieceMesh& own = mesh.pieces[piece];
        if (own.folds.empty()) continue;
        const pattern::Piece shape = pattern::resolved(pattern, *pattern.pieces[piece]);
        const auto sides = foldSides(own, piece);
        for (int fold = 0; fold < std::ssize(own.folds); ++fold) {
            const std::vector<int>& nodes = own.folds[fold];
            all.push_back({piece, fold, model.hinges.size(), 0});
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
                const CellSide &left = sides.at({nodes[i], nodes[i + 1]}), &right = sides.at({nodes[i + 1], nodes[i]});
                appendHinges(model, mesh, particles, left, right,
                             {shape.folds[fold].stiffnessFactor * bendingAcross(own, left, cloths[piece]),
                              shape.folds[fold].angle});
            }
            all.back().end = model.hinges.size();
        }
    }
    return all;
}

std::ptrdiff_t hingesOf(std::span<const FoldHinges> folds) {
    std::ptrdiff_t count = 0;
    for (const FoldHinges& fold : folds) count += static_cast<std::ptrdiff_t>(fold.end - fold.first);
    return count;
}

std::vector<FoldReport> foldReports(const pattern::Pattern& pattern, const cloth::ClothModel& model,
                                    std::span<const FoldHinges> folds, std::span<const Vec3> positions) {
    std::vector<FoldReport> reports;
    for (const FoldHinges& fold : folds) {
        const pattern::Piece piece = pattern::resolved(pattern, *pattern.pieces[fold.piece]);
        FoldReport report{piece.name, piece.folds[fold.fold].name, piece.folds[fold.fold].angle, 0, 0, 0};
        double length = 0;
        for (std::size_t h = fold.first; h < fold.end; ++h) {
            const cloth::Hinge& hinge = model.hinges[h];
            const double angle =
                report.restAngle +
                cloth::angleFrom(report.restAngle, cloth::foldAngle(positions[hinge.a], positions[hinge.b],
                                                                    positions[hinge.c], positions[hinge.d])
                                                       .angle);
            const double own = geometry::distance(positions[hinge.a], positions[hinge.b]);
            report.least = h == fold.first ? angle : std::min(report.least, angle);
            report.most = h == fold.first ? angle : std::max(report.most, angle);
            report.mean += angle * own;
            length += own;
        }
        if (length > 0) report.mean /= length;
        reports.push_back(std::move(report));
    }
    return reports;
}

} // namespace toile::simulation
