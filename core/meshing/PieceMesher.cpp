// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PieceMesher.h"

#include "core/meshing/BorderSpacing.h"
#include "core/meshing/FinishedPiece.h"
#include "core/meshing/MainLines.h"
#include "core/meshing/PairMerge.h"
#include "core/meshing/Quality.h"
#include "core/meshing/StripImprovement.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Whether a triangle's height is more than the rounding of coordinates.
bool hasArea(const std::vector<Vec2>& places, const std::array<int, 3>& nodes, double leastHeight) {
    const auto corner = [&](std::size_t i) { return places[at(nodes[i % 3])]; };
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i) longest = std::max(longest, distance(corner(i), corner(i + 1)));
    return cross(corner(1) - corner(0), corner(2) - corner(0)) > leastHeight * longest;
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

/// What only the input can say of a mesh.
void judgeAgainstInput(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& nodes,
                       const PieceMesh& mesh, PieceReport& report) {
    const double exact = exactArea(piece);
    report.areaRelativeError = std::abs(meshedArea(mesh) - exact) / exact;
    report.boundaryDeviation = boundaryDeviation(piece, boundary, nodes);
    report.inputMinimumAngle = smallestBorderAngle(nodes);
}

} // namespace

Result<Lattice> laidLattice(const PieceInput& piece, const PieceBoundary& boundary, const std::vector<Vec2>& seamEnds,
                            const GrainStretches& stretches, std::vector<RegionReport>& reports,
                            std::vector<Warning>& warnings) {
    MainLines lines = mainLines(piece, boundary, seamEnds, stretches);
    if (auto fits = affordable(piece, lines.x.size(), lines.y.size()); !fits) return tl::unexpected(fits.error());
    Lattice lattice(std::move(lines.x), std::move(lines.y));
    markActiveCells(boundary.frame, boundary.contours, lattice);
    auto regions = snapRegions(piece, boundary, lattice, warnings);
    if (!regions) return tl::unexpected(regions.error());
    reports = std::move(*regions);
    if (auto fits = affordable(piece, lattice); !fits) return tl::unexpected(fits.error());
    return lattice;
}

Result<PieceMesh> meshedPiece(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& nodes,
                              const std::vector<SpacingSeed>& seeds, Lattice lattice) {
    markActiveCells(boundary.frame, ringPoints(nodes), lattice);
    const bool literal = piece.rule == LineRule::paper;
    if (!literal) {
        seedFromBorder(seeds, lattice);
        balance(lattice);
    }
    if (auto fits = affordable(piece, lattice); !fits) return tl::unexpected(fits.error());
    lattice.numberNodes();
    GridFill fill = fillLattice(boundary.frame, nodes, lattice, literal ? paperClearance : clearance);
    CellMesh cells = cellMesh(boundary.frame, nodes, lattice, fill);
    improveStrip(boundary.frame, nodes, lattice, fill, cells, {.passes = literal ? 0 : ImprovementSettings{}.passes});
    mergePairs(cells);
    PieceMesh mesh = finishedPiece(boundary.frame, nodes, cells).mesh;
    if (auto sound = everyTriangleHasArea(piece, boundary.frame, mesh); !sound) return tl::unexpected(sound.error());
    return mesh;
}

PieceReport pieceReport(const PieceInput& piece, const PieceBoundary& boundary, const BoundaryNodes& nodes,
                        const PieceMesh& mesh, bool judged) {
    PieceReport report = countsOf(mesh);
    report.label = piece.label;
    if (!judged) return report;
    judge(mesh, report);
    judgeAgainstInput(piece, boundary, nodes, mesh, report);
    return report;
}

} // namespace toile::meshing
