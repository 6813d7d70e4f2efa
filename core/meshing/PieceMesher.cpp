// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PieceMesher.h"
#include "core/base/Index.h"

#include "core/meshing/BorderSpacing.h"
#include "core/meshing/FoldNodes.h"
#include "core/meshing/MainLines.h"
#include "core/meshing/Quality.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

/// Whether a triangle's height is more than the rounding of coordinates.
bool hasArea(const std::vector<Vec2>& places, const std::array<int, 3>& nodes, double leastHeight) {
    const auto corner = [&](std::size_t i) { return places[at(nodes[i % 3])]; };
    double longest = 0; // squared
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, squaredLength(corner(i + 1) - corner(i)));
    const double area = cross(corner(1) - corner(0), corner(2) - corner(0));
    return area > 0 && area * area > leastHeight * leastHeight * longest;
}

/// Details of the border as small as the rounding of the grid, and nodes of a straight border beside a rectangle's
/// side, leave triangles without area: where the nodes were given, or in material coordinates.
Result<void> everyTriangleHasArea(const PieceInput& piece, const PieceFrame& frame, const PieceMesh& mesh) {
    const double leastHeight = 1e-3 * frame.unit;
    for (const Triangle& triangle : mesh.triangles) {
        if (hasArea(mesh.nodes, triangle.nodes, leastHeight) && hasArea(mesh.material, triangle.nodes, leastHeight))
            continue;
        return fail(ErrorCode::invalidInput,
                    "The border comes nearer to itself or to a line of the mesh than " + micrometres(8 * frame.unit) +
                        " at " + pointText(mesh.nodes[at(triangle.nodes[0])]) + ".",
                    {.object = nameOf(piece)});
    }
    return {};
}

FoldReport reportOnFold(const FoldInput& fold, const PieceMesh& mesh, const std::vector<int>& nodes) {
    FoldReport report{fold.label, static_cast<int>(nodes.size()), 0, 0};
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
        report.length += distance(mesh.nodes[at(nodes[i])], mesh.nodes[at(nodes[i + 1])]);
    for (const Vec2 drawn : fold.points) {
        double nearest = distance(drawn, mesh.nodes[at(nodes.front())]);
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
            nearest =
                std::min(nearest, distance(drawn, geometry::closestOnSegment(mesh.nodes[at(nodes[i])],
                                                                             mesh.nodes[at(nodes[i + 1])], drawn)));
        report.deviation = std::max(report.deviation, nearest);
    }
    return report;
}

/// What only the input can say of a mesh.
void judgeAgainstInput(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& nodes,
                       const PieceMesh& mesh, PieceReport& report) {
    const double exact = exactArea(piece);
    report.areaRelativeError = std::abs(meshedArea(mesh) - exact) / exact;
    report.boundaryDeviation = boundaryDeviation(piece, boundary, nodes);
    report.inputMinimumAngle = smallestBorderAngle(nodes);
}

} // namespace

Result<void> LatticeLayer::run(const PieceInput& piece, const PieceBoundary& boundary, std::span<const Vec2> seamEnds,
                               const GrainStretches& stretches, Arena& arena, LaidLattice& laid) {
    laid.warnings.clear();
    laid.regions.resize(piece.regions.size());
    const MainLines lines = mainLines(piece, boundary, seamEnds, stretches, arena);
    if (auto fits = affordable(piece, lines.x.size(), lines.y.size()); !fits) return fits;
    laid.lattice.lay(lines.x, lines.y);
    if (piece.regions.empty()) return {};
    lines_.assign(boundary.frame, laid.lattice);
    segments_.assign(boundary.contours, lines_);
    markActiveCells(lines_, segments_, laid.lattice);
    auto snapped = snapRegions(piece, boundary, arena, laid.lattice, laid.regions, laid.warnings);
    if (!snapped) return snapped;
    return affordable(piece, laid.lattice);
}

Result<void> PieceMesher::run(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& border,
                              const std::vector<SpacingSeed>& seeds, const Lattice& laid, PieceMesh& mesh) {
    const PieceFrame& frame = boundary.frame;
    const bool literal = piece.rule == LineRule::paper;
    lattice_ = laid;
    fill_.lines.assign(frame, lattice_);
    segments_.assign(border, fill_.lines);
    markActiveCells(fill_.lines, segments_, lattice_);
    if (!literal) {
        seedFromBorder(seeds, lattice_);
        balance(lattice_, open_);
    }
    if (auto fits = affordable(piece, lattice_); !fits) return tl::unexpected(fits.error());
    lattice_.number();
    if (!piece.folds.empty()) {
        folded_ = border;
        if (auto added = addFoldNodes(piece, boundary, lattice_, folded_); !added) return added;
        segments_.assign(folded_, fill_.lines);
    }
    const BoundaryNodes& nodes = piece.folds.empty() ? border : folded_;
    filler_.run(frame, nodes, segments_, lattice_, literal ? paperClearance : clearance, fill_);
    const NodePlaces places(frame, nodes, lattice_, fill_, borderPlaces_);
    improver_.run(frame, nodes, lattice_, places, fill_, layer_, strip_,
                  {.passes = literal ? 0 : ImprovementSettings{}.passes});
    merger_.run(strip_);
    finisher_.run(frame, nodes, lattice_, places, fill_, layer_, strip_, mesh);
    return everyTriangleHasArea(piece, frame, mesh);
}

void reportOn(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& nodes, const PieceMesh& mesh,
              bool judged, PieceReport& report) {
    PieceReport counts = countsOf(mesh);
    counts.label = std::move(report.label);
    counts.regions = std::move(report.regions);
    report = std::move(counts);
    report.label = piece.label;
    report.spacing = piece.spacing;
    for (std::size_t fold = 0; fold < piece.folds.size(); ++fold)
        report.folds.push_back(reportOnFold(piece.folds[fold], mesh, mesh.folds[fold]));
    if (!judged) return;
    judge(mesh, report);
    judgeAgainstInput(piece, boundary, nodes, mesh, report);
}

} // namespace toile::meshing
