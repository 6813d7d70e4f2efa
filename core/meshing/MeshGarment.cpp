// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Contracts.h"
#include "core/base/Parallel.h"
#include "core/meshing/BorderSpacing.h"
#include "core/meshing/FinishedPiece.h"
#include "core/meshing/GarmentMesh.h"
#include "core/meshing/MainLines.h"
#include "core/meshing/PairMerge.h"
#include "core/meshing/Quality.h"
#include "core/meshing/Regions.h"
#include "core/meshing/StripImprovement.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Doubling where parts of the border run too near one another ends at so many nodes of a piece, and so many
/// times those it began with.
constexpr std::size_t mostBorderNodes = 100000, mostTimesNodes = 16;

/// Doubles each stretch once, however many of its segments are too coarse.
void refineOnce(const std::vector<BoundarySpot>& spots, int piece, BoundaryDivision& division) {
    std::vector<int> done;
    for (const BoundarySpot& spot : spots) {
        division.takeEveryVertex(piece, spot.loop);
        for (const Stretch& stretch : division.stretches(piece, spot.loop, spot.edge)) {
            if (spot.fraction < stretch.from || spot.fraction > stretch.to) continue;
            if (std::find(done.begin(), done.end(), stretch.group) != done.end()) continue;
            done.push_back(stretch.group);
            division.refine(stretch.group);
        }
    }
}

/// Refuses nodes so near one another that the integer grid could not tell a straight line from a bent one.
Result<void> nodesApart(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                        const BoundaryDivision& division) {
    constexpr double least = 64; // units
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        for (int loop = 0; loop < loopCount(input.pieces[p]); ++loop)
            for (int e = 0; e < static_cast<int>(loopOf(input.pieces[p], loop).size()); ++e) {
                const double length = boundaries[p].loops[at(loop)].edges[at(e)].length;
                for (const Stretch& stretch : division.stretches(static_cast<int>(p), loop, e)) {
                    const int count = division.count(stretch);
                    const double spacing = length * (stretch.to - stretch.from) / count;
                    if (count > 1 && spacing < least * boundaries[p].frame.unit)
                        return fail(ErrorCode::invalidInput,
                                    "What is sewn to the edge asks for " + std::to_string(count) + " nodes on " +
                                        millimetres(spacing * count) +
                                        " of it; gather less, or choose larger spacings.",
                                    {.object = nameOf(input.pieces[p], loop, e)});
                }
            }
    return {};
}

/// Divides all borders, finer where the polygon through the nodes would cross itself.
Result<BoundaryDivision> dividedBorders(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                                        const std::vector<CheckedSeam>& seams, const FixedPoints& points,
                                        const SpacingAlong& spacing, std::vector<BoundaryNodes>& nodes) {
    auto division = BoundaryDivision::create(input, boundaries, seams, points, spacing);
    if (!division) return division;
    if (auto apart = nodesApart(input, boundaries, *division); !apart) return tl::unexpected(apart.error());
    std::vector<std::size_t> firstCounts;
    for (;;) {
        bool coarse = false;
        nodes.clear();
        for (std::size_t p = 0; p < input.pieces.size(); ++p) {
            nodes.push_back(boundaryNodes(input.pieces[p], static_cast<int>(p), boundaries[p], *division));
            if (firstCounts.size() <= p) firstCounts.push_back(nodes.back().points.size());
            std::vector<BoundarySpot> spots = spotsTooCoarse(nodes.back());
            if (spots.empty()) continue;
            coarse = true;
            if (nodes.back().points.size() > std::max(mostBorderNodes, mostTimesNodes * firstCounts[p]))
                return fail(ErrorCode::invalidInput,
                            "Two parts of the border run too near one another to be divided into nodes.",
                            {.object = nameOf(input.pieces[p], spots.front().loop, spots.front().edge)});
            refineOnce(spots, static_cast<int>(p), *division);
        }
        if (!coarse) return division;
    }
}

SeamNodes nodesOf(const CheckedSeam& seam, const BoundaryDivision& division, const std::vector<PieceMesh>& pieces) {
    std::array<std::vector<std::vector<NodeRef>>, 2> stretches;
    for (std::size_t side = 0; side < 2; ++side)
        for (const ChainPart& part : seam.sides[side].parts) {
            const SeamPartInput& where = part.part;
            const EdgeNodes& edge = pieces[at(where.piece)].loops[at(where.loop)][at(where.edge)];
            std::vector<std::vector<NodeRef>> own;
            for (const Stretch& stretch : division.stretches(where.piece, where.loop, where.edge)) {
                const double middle = 0.5 * (stretch.from + stretch.to);
                if (middle < where.from || middle > where.to) continue;
                auto& list = own.emplace_back();
                for (const EdgeNode& node : edge)
                    if (node.fraction >= stretch.from - 1e-12 && node.fraction <= stretch.to + 1e-12)
                        list.push_back({where.piece, node.node});
                if (where.reversed) std::reverse(list.begin(), list.end());
            }
            if (where.reversed) std::reverse(own.begin(), own.end());
            stretches[side].insert(stretches[side].end(), own.begin(), own.end());
        }
    SeamNodes nodes;
    for (std::size_t i = 0; i < stretches[0].size(); ++i)
        for (std::size_t k = 0; k < stretches[0][i].size(); ++k) {
            const std::array<NodeRef, 2> pair{stretches[0][i][k], stretches[1][i][k]};
            if (nodes.pairs.empty() || nodes.pairs.back() != pair) nodes.pairs.push_back(pair);
        }
    return nodes;
}

/// By how much the ways between neighbouring pairs differ: 0 unless there is ease, or a curve's chords fall
/// short.
double largestSpacingMismatch(const SeamNodes& nodes, const std::vector<PieceMesh>& pieces) {
    double largest = 0;
    for (std::size_t k = 0; k + 1 < nodes.pairs.size(); ++k) {
        std::array<double, 2> way{};
        for (std::size_t side = 0; side < 2; ++side) {
            const NodeRef from = nodes.pairs[k][side], to = nodes.pairs[k + 1][side];
            if (from.piece == to.piece)
                way[side] =
                    distance(pieces[at(from.piece)].nodes[at(from.node)], pieces[at(to.piece)].nodes[at(to.node)]);
        }
        if (way[0] > 0 && way[1] > 0) largest = std::max(largest, std::abs(way[0] - way[1]) / std::max(way[0], way[1]));
    }
    return largest;
}

/// One more than the parts between sewing points; a joint of two pieces is one point.
int sewingPoints(const SeamChain& side, const BoundaryDivision& division) {
    int points = 1;
    for (const ChainPart& part : side.parts)
        for (const Stretch& stretch : division.stretches(part.part.piece, part.part.loop, part.part.edge)) {
            const double middle = 0.5 * (stretch.from + stretch.to);
            if (middle >= part.part.from && middle <= part.part.to) points += division.count(stretch);
        }
    return points;
}

SeamReport reportOf(const SeamInput& input, const CheckedSeam& seam, const SeamNodes& nodes,
                    const BoundaryDivision& division, const std::vector<PieceMesh>& pieces) {
    SeamReport report{input.label, 0, 0, seam.sides[0].length, seam.sides[1].length, seam.ease, 0};
    report.countA = sewingPoints(seam.sides[0], division);
    report.countB = sewingPoints(seam.sides[1], division);
    report.largestSpacingMismatch = largestSpacingMismatch(nodes, pieces);
    return report;
}

/// The ends of seam parts on a piece, in its frame.
std::vector<Vec2> seamEnds(const std::vector<CheckedSeam>& seams, int piece, const PieceBoundary& boundary) {
    std::vector<Vec2> ends;
    for (const CheckedSeam& seam : seams)
        for (const SeamChain& side : seam.sides)
            for (const ChainPart& part : side.parts)
                for (const double fraction : {part.part.from, part.part.to})
                    if (part.part.piece == piece)
                        ends.push_back(boundary.frame.frameOf(
                            boundary.loops[at(part.part.loop)].edges[at(part.part.edge)].arc.pointAt(fraction)));
    return ends;
}

/// The main mesh with the regions on it.
Result<Lattice> latticeOf(const PieceInput& piece, const PieceBoundary& boundary, const std::vector<Vec2>& seamEnds,
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

/// Details of the border as small as the rounding of the grid leave triangles without area in material
/// coordinates.
Result<void> everyTriangleHasArea(const PieceInput& piece, const PieceFrame& frame, const CellMesh& cells) {
    for (const Triangle& triangle : cells.triangles) {
        const auto corner = [&](std::size_t i) { return cells.position[at(triangle.nodes[i])]; };
        if (cross(corner(1) - corner(0), corner(2) - corner(0)) > 0) continue;
        return fail(ErrorCode::invalidInput,
                    "The border comes nearer to itself than " + micrometres(8 * frame.unit) + " at " +
                        pointText(frame.pointFromFrame(corner(0))) + ".",
                    {.object = nameOf(piece)});
    }
    return {};
}

/// From frozen border nodes to the finished mesh.
Result<PieceMesh> meshedPiece(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary,
                              const BoundaryNodes& nodes, const BoundaryDivision& division, Lattice& lattice) {
    markActiveCells(boundary.frame, ringPoints(nodes), lattice);
    const bool literal = piece.rule == LineRule::paper;
    if (!literal) {
        seedFromBorder(seedsOf(nodes, boundary.frame, pieceIndex, division), lattice);
        balance(lattice);
    }
    if (auto fits = affordable(piece, lattice); !fits) return tl::unexpected(fits.error());
    lattice.numberNodes();
    GridFill fill = fillLattice(boundary.frame, nodes, lattice, literal ? paperClearance : clearance);
    CellMesh cells = cellMesh(boundary.frame, nodes, lattice, fill);
    improveStrip(boundary.frame, nodes, lattice, fill, cells, {.passes = literal ? 0 : ImprovementSettings{}.passes});
    if (auto sound = everyTriangleHasArea(piece, boundary.frame, cells); !sound) return tl::unexpected(sound.error());
    mergePairs(cells);
    return finishedPiece(boundary.frame, nodes, cells).mesh;
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

SewnAlike sewnAlike(const SeamReport& seam) {
    constexpr double chords = 0.02; // a curve's chord falls short of its arc by s²/24R²: 1.7 % at s = 0.64 R
    const double longer = std::max(seam.lengthA, seam.lengthB);
    const double rest = std::abs(seam.lengthA - seam.lengthB - seam.ease);
    SewnAlike alike;
    alike.length = rest <= std::max(1e-3, 3e-3 * longer);
    alike.count = seam.countA == seam.countB;
    alike.unit = seam.largestSpacingMismatch <= std::abs(seam.lengthA - seam.lengthB) / longer + chords;
    return alike;
}

Result<GarmentMesh> meshGarment(const MeshInput& input, const MeshSettings& settings) {
    const int pieceCount = static_cast<int>(input.pieces.size());
    GarmentMesh garment;
    garment.report.pieces.resize(input.pieces.size());
    std::vector<std::vector<RegionReport>> regions(input.pieces.size());
    std::vector<PieceBoundary> boundaries;
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        auto boundary = checkedBoundary(input.pieces[p]);
        if (!boundary) return tl::unexpected(boundary.error());
        boundaries.push_back(std::move(*boundary));
    }
    std::vector<CheckedSeam> seams;
    for (const SeamInput& seam : input.seams) {
        auto checked = checkedSeam(input, seam, boundaries, garment.report.warnings);
        if (!checked) return tl::unexpected(checked.error());
        seams.push_back(std::move(*checked));
    }
    const auto points = fixedPoints(input, boundaries, seams);
    if (!points) return tl::unexpected(points.error());
    // Regions are snapped before the border is divided, because they say how finely; without regions it is
    // the other way round, and lines can pass through whatever nodes the seams ask for.
    std::vector<std::optional<Lattice>> lattices(input.pieces.size());
    const auto layLattice = [&](std::size_t p, const GrainStretches& stretches) -> Result<void> {
        auto lattice = latticeOf(input.pieces[p], boundaries[p], seamEnds(seams, static_cast<int>(p), boundaries[p]),
                                 stretches, regions[p], garment.report.warnings);
        if (!lattice) return tl::unexpected(lattice.error());
        lattices[p] = std::move(*lattice);
        return {};
    };
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        if (!input.pieces[p].regions.empty())
            if (auto laid = layLattice(p, grainStretches(input.pieces[p], boundaries[p], (*points)[p])); !laid)
                return tl::unexpected(laid.error());
    const SpacingAlong spacing = [&](int piece, int loop, int edge, double from, double to) {
        if (!lattices[at(piece)]) return input.pieces[at(piece)].spacing;
        return finestSpacingAlong(input.pieces[at(piece)], boundaries[at(piece)], *lattices[at(piece)], loop, edge,
                                  from, to);
    };
    std::vector<BoundaryNodes> nodes;
    const auto division = dividedBorders(input, boundaries, seams, *points, spacing, nodes);
    if (!division) return tl::unexpected(division.error());
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        if (!lattices[p])
            if (auto laid =
                    layLattice(p, division->grainStretches(input.pieces[p], static_cast<int>(p), boundaries[p]));
                !laid)
                return tl::unexpected(laid.error());

    std::vector<Result<PieceMesh>> meshes(input.pieces.size());
    inParallel(pieceCount, [&](int p) { // each piece on its own: the result does not depend on the threads
        const auto start = std::chrono::steady_clock::now();
        const std::size_t i = at(p);
        meshes[i] = meshedPiece(input.pieces[i], p, boundaries[i], nodes[i], *division, *lattices[i]);
        if (!meshes[i]) return;
        PieceReport& report = garment.report.pieces[i] = countsOf(*meshes[i]);
        report.label = input.pieces[i].label;
        report.regions = std::move(regions[i]);
        report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        if (!settings.judged) return;
        judge(*meshes[i], report);
        judgeAgainstInput(input.pieces[i], boundaries[i], nodes[i], *meshes[i], report);
    });
    for (auto& mesh : meshes) {
        if (!mesh) return tl::unexpected(mesh.error());
        garment.pieces.push_back(std::move(*mesh));
    }
    garment.report.total = totalOf(garment.report.pieces);
    for (std::size_t s = 0; s < seams.size(); ++s) {
        garment.seams.push_back(nodesOf(seams[s], *division, garment.pieces));
        garment.report.seams.push_back(
            reportOf(input.seams[s], seams[s], garment.seams.back(), *division, garment.pieces));
    }
    return garment;
}

} // namespace toile::meshing
