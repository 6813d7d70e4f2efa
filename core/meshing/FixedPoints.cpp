// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FixedPoints.h"
#include "core/base/Index.h"

#include "core/meshing/LineCrossings.h"

#include <algorithm>

namespace toile::meshing {
namespace {

constexpr double samePlace = 1e-5; ///< fixed points nearer than this along an edge are one [m]
constexpr int mostRounds = 64;

const EdgeArc& arcOf(const std::vector<PieceBoundary>& boundaries, int piece, int loop, int edge) {
    return boundaries[at(piece)].loops[at(loop)].edges[at(edge)];
}

std::pmr::vector<double>& pointsOf(FixedPoints& points, const SeamPartInput& part) {
    return points[at(part.piece)][at(part.loop)][at(part.edge)];
}

/// Adds a fixed point unless one is there already; says whether it did.
bool addPoint(std::pmr::vector<double>& points, double fraction, double edgeLength) {
    const auto above = std::lower_bound(points.begin(), points.end(), fraction);
    const double tolerance = std::max(1e-12, samePlace / std::max(edgeLength, 1e-9));
    if (above != points.end() && *above - fraction <= tolerance) return false;
    if (above != points.begin() && fraction - *std::prev(above) <= tolerance) return false;
    points.insert(above, fraction);
    return true;
}

FixedPoints ownPoints(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                      std::span<const CheckedSeam> seams, Arena& arena) {
    FixedPoints points(&arena);
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        auto& loops = points.emplace_back();
        for (int loop = 0; loop < loopCount(input.pieces[p]); ++loop) {
            auto& edges = loops.emplace_back();
            for (std::size_t e = 0; e < loopOf(input.pieces[p], loop).size(); ++e) {
                auto& own = edges.emplace_back();
                own.assign({0, 1});
                const EdgeArc& arc = boundaries[p].loops[at(loop)].edges[e];
                if (arc.collapsed) continue;
                for (const double notch : loopOf(input.pieces[p], loop)[e].notches) addPoint(own, notch, arc.length);
                for (const FoldInput& fold : input.pieces[p].folds)
                    for (const FoldEndInput& end : fold.ends)
                        if (end.loop == loop && end.edge == static_cast<int>(e))
                            addPoint(own, end.fraction, arc.length);
            }
        }
    }
    for (const CheckedSeam& seam : seams)
        for (const SeamChain& side : seam.sides)
            for (const ChainPart& part : side.parts)
                for (const double end : {part.part.from, part.part.to})
                    addPoint(pointsOf(points, part.part), end,
                             arcOf(boundaries, part.part.piece, part.part.loop, part.part.edge).length);
    return points;
}

/// The fixed points of a part in walking order, as fractions of its edge; both ends included.
std::pmr::vector<double> pointsAlong(std::span<const double> points, const ChainPart& part, double edgeLength,
                                     Arena& arena) {
    const double tolerance = samePlace / edgeLength;
    std::pmr::vector<double> along(&arena);
    for (const double fraction : points)
        if (fraction >= part.part.from - tolerance && fraction <= part.part.to + tolerance) along.push_back(fraction);
    if (part.part.reversed) std::reverse(along.begin(), along.end());
    return along;
}

/// Carries the fixed points of one side of a seam to the other; says whether anything was new.
bool carryAcross(const CheckedSeam& seam, int side, const std::vector<PieceBoundary>& boundaries, Arena& arena,
                 FixedPoints& points) {
    bool added = false;
    const SeamChain& other = seam.sides[at(1 - side)];
    for (const ChainPart& part : seam.sides[at(side)].parts) {
        const double edgeLength = arcOf(boundaries, part.part.piece, part.part.loop, part.part.edge).length;
        for (const double fraction : pointsAlong(pointsOf(points, part.part), part, edgeLength, arena)) {
            const double chain =
                seam.across(side, std::clamp(part.chainOf(fraction), part.start, part.start + part.length));
            for (const ChainPart& target : other.parts) {
                if (chain < target.start + samePlace || chain > target.start + target.length - samePlace) continue;
                const EdgeArc& arc = arcOf(boundaries, target.part.piece, target.part.loop, target.part.edge);
                added |= addPoint(pointsOf(points, target.part), target.fractionOf(chain), arc.length);
            }
        }
    }
    return added;
}

/// Gives free straight edges the line places of their piece, so that lines from the edges they face meet
/// their nodes.
void carryAcrossPiece(const PieceInput& piece, const PieceBoundary& boundary, const SewnEdges& sewn, Arena& arena,
                      PiecePoints& points) {
    const GrainStretches stretches = grainStretches(piece, boundary, points, arena);
    for (const int axis : {0, 1}) {
        const auto places = linePlaces(piece, boundary.frame, axis, stretches[at(axis)], arena);
        for (const GrainSpan& span : grainSpans(piece, boundary, axis, arena)) {
            if (sewn[at(span.loop)][at(span.edge)]) continue;
            for (const double place : places)
                if (place > span.low() && place < span.high())
                    addPoint(points[at(span.loop)][at(span.edge)], span.fractionOf(place), span.high() - span.low());
        }
    }
}

/// The paper has a node wherever a scan line meets the border; edges that are sewn are divided evenly
/// instead.
void addLineCrossings(const PieceInput& piece, const PieceBoundary& boundary, const SewnEdges& sewn, Arena& arena,
                      PiecePoints& points) {
    const auto crossings = lineCrossings(piece, boundary, arena);
    for (std::size_t loop = 0; loop < points.size(); ++loop)
        for (std::size_t e = 0; e < points[loop].size(); ++e)
            for (const double fraction : crossings[loop][e])
                if (!sewn[loop][e]) addPoint(points[loop][e], fraction, boundary.loops[loop].edges[e].length);
}

} // namespace

SewnEdges sewnEdges(const PieceInput& piece, int pieceIndex, std::span<const CheckedSeam> seams, Arena& arena) {
    SewnEdges sewn(&arena);
    for (int loop = 0; loop < loopCount(piece); ++loop) sewn.emplace_back(loopOf(piece, loop).size(), char{0});
    for (const CheckedSeam& seam : seams)
        for (const SeamChain& side : seam.sides)
            for (const ChainPart& part : side.parts)
                if (part.part.piece == pieceIndex) sewn[at(part.part.loop)][at(part.part.edge)] = 1;
    return sewn;
}

Result<FixedPoints> fixedPoints(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                                std::span<const CheckedSeam> seams, Arena& arena) {
    FixedPoints points = ownPoints(input, boundaries, seams, arena);
    bool changed = true;
    for (int round = 0; changed; ++round) {
        changed = false;
        for (std::size_t s = 0; s < seams.size(); ++s) {
            const bool added = carryAcross(seams[s], 0, boundaries, arena, points) |
                               carryAcross(seams[s], 1, boundaries, arena, points);
            if (added && round >= mostRounds)
                return fail(ErrorCode::invalidInput,
                            "The seam carries its own points on and on along the same edges; seams that "
                            "share an edge do not fit together.",
                            {.object = nameOf(input.seams[s])});
            changed |= added;
        }
    }
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        const PieceInput& piece = input.pieces[p];
        const SewnEdges sewn = sewnEdges(piece, static_cast<int>(p), seams, arena);
        if (piece.rule == LineRule::regular) carryAcrossPiece(piece, boundaries[p], sewn, arena, points[p]);
        if (piece.rule == LineRule::paper) addLineCrossings(piece, boundaries[p], sewn, arena, points[p]);
    }
    return points;
}

} // namespace toile::meshing
