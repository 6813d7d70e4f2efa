// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/SeamDivision.h"
#include "core/base/Index.h"

#include "core/meshing/LineCrossings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace toile::meshing {
namespace {

constexpr double samePlace = 1e-5; ///< ends of facing stretches nearer than this face one another [m]

/// Disjoint sets of stretches that must carry equal counts.
struct Groups {
    std::pmr::vector<int> parent;
    int rootOf(int i) {
        while (parent[at(i)] != i) i = parent[at(i)] = parent[at(parent[at(i)])];
        return i;
    }
    void join(int a, int b) { parent[at(rootOf(a))] = rootOf(b); }
};

/// The edge lies along the grain, so that main lines may pass through its nodes.
bool isLined(const PieceInput& piece, const PieceBoundary& boundary, int loop, int edge) {
    const Curve& curve = loopOf(piece, loop)[at(edge)].curve;
    if (piece.rule != LineRule::regular || !std::holds_alternative<geometry::LineShape>(curve.shape)) return false;
    const Vec2 a = boundary.frame.frameOf(curve.start), b = boundary.frame.frameOf(curve.end);
    return std::min(std::abs(b.x - a.x), std::abs(b.y - a.y)) <= 2 * boundary.frame.unit;
}

/// A whole number of parts for each main cell, so that its lines and those between them meet the nodes.
int partsOnLines(double length, double spacing, double finest) {
    return partsOf(length, spacing) * static_cast<int>(std::lround(spacing / finest));
}

/// Into how many parts scan lines cut a stretch of an edge.
int partsBetween(std::span<const double> crossings, double from, double to) {
    constexpr double same = 1e-9; // a crossing that is an end of the stretch cuts nothing off
    return 1 + static_cast<int>(std::count_if(crossings.begin(), crossings.end(), [&](double crossing) {
               return crossing > from + same && crossing < to - same;
           }));
}

constexpr double shortEdge = 0.25;                             ///< of the spacing; longer edges keep their ends [–]
constexpr double sharpTurn = 15 * std::numbers::pi / 180;      ///< a corner [rad]
constexpr double largestRunTurn = 30 * std::numbers::pi / 180; ///< between two nodes of a run [rad]

double turnBetween(const Curve& in, const Curve& out) {
    const Vec2 a = in.end - in.start, b = out.end - out.start;
    return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

/// Marks which ends of edges of a loop are no nodes: those inside smooth runs of short free lines, but for one per
/// spacing.
void markPassedEnds(const PieceInput& piece, int loop, const LoopBoundary& arcs, std::span<const char> sewn,
                    std::span<char> passed) {
    const BoundaryLoop& edges = loopOf(piece, loop);
    const double spacing = piece.spacing;
    const std::size_t n = edges.size();
    const auto isFoldedAt = [&](std::size_t e) {
        for (const FoldInput& fold : piece.folds)
            for (const FoldEndInput& end : fold.ends)
                if (end.loop == loop && at(end.edge) == e) return true;
        return false;
    };
    const auto isShort = [&](std::size_t e) {
        return !sewn[e] && !isFoldedAt(e) && !arcs.edges[e].collapsed && edges[e].notches.empty() &&
               arcs.edges[e].length < shortEdge * spacing &&
               std::holds_alternative<geometry::LineShape>(edges[e].curve.shape);
    };
    double length = 0, turn = 0;
    for (std::size_t e = 0; e + 1 < n; ++e) {
        length += arcs.edges[e].length;
        const double here = turnBetween(edges[e].curve, edges[e + 1].curve);
        turn += here;
        passed[e] = isShort(e) && isShort(e + 1) && here < sharpTurn && turn < largestRunTurn &&
                    length + arcs.edges[e + 1].length <= spacing;
        if (!passed[e]) length = turn = 0;
    }
}

} // namespace

Result<BoundaryDivision> BoundaryDivision::create(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                                                  std::span<const CheckedSeam> seams, const FixedPoints& points,
                                                  const SpacingAlong& spacing, Arena& arena) {
    BoundaryDivision division(arena);
    Groups groups{std::pmr::vector<int>(&arena)};
    std::pmr::vector<int> needed(&arena);
    for (std::size_t p = 0; p < points.size(); ++p) {
        auto& loops = division.stretches_.emplace_back();
        const bool literal = input.pieces[p].rule == LineRule::paper;
        const PiecePoints crossings =
            literal ? lineCrossings(input.pieces[p], boundaries[p], arena) : PiecePoints(&arena);
        for (std::size_t loop = 0; loop < points[p].size(); ++loop) {
            auto& edges = loops.emplace_back();
            for (std::size_t e = 0; e < points[p][loop].size(); ++e) {
                auto& own = edges.emplace_back();
                const std::span<const double> places = points[p][loop][e];
                const EdgeArc& arc = boundaries[p].loops[loop].edges[e];
                const bool lined = isLined(input.pieces[p], boundaries[p], static_cast<int>(loop), static_cast<int>(e));
                for (std::size_t i = 0; i + 1 < places.size(); ++i) {
                    const int group = static_cast<int>(needed.size());
                    own.push_back({places[i], places[i + 1], group});
                    const double length = arc.length * (places[i + 1] - places[i]);
                    const double finest = spacing(static_cast<int>(p), static_cast<int>(loop), static_cast<int>(e),
                                                  places[i], places[i + 1]);
                    needed.push_back(arc.collapsed ? 1
                                     : literal     ? partsBetween(crossings[loop][e], places[i], places[i + 1]) *
                                                     static_cast<int>(std::lround(input.pieces[p].spacing / finest))
                                     : lined ? partsOnLines(length, input.pieces[p].spacing, finest)
                                             : partsOf(length, finest));
                    groups.parent.push_back(group);
                }
            }
        }
    }
    division.passed_.resize(input.pieces.size());
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        const SewnEdges sewn = sewnEdges(input.pieces[p], static_cast<int>(p), seams, arena);
        for (int loop = 0; loop < loopCount(input.pieces[p]); ++loop) {
            const BoundaryLoop& edges = loopOf(input.pieces[p], loop);
            auto& passed = division.passed_[p].emplace_back(edges.size(), char{0});
            if (input.pieces[p].rule == LineRule::paper) continue; // a node at every authored vertex
            markPassedEnds(input.pieces[p], loop, boundaries[p].loops[at(loop)], sewn[at(loop)], passed);
        }
    }
    for (std::size_t s = 0; s < seams.size(); ++s) {
        const std::pmr::vector<int> a = division.groupsAlong(seams[s].sides[0], arena);
        const std::pmr::vector<int> b = division.groupsAlong(seams[s].sides[1], arena);
        if (a.size() != b.size())
            return fail(ErrorCode::invalidInput, "Fixed points of the two sides lie too near one another to be paired.",
                        {.object = nameOf(input.seams[s])});
        for (std::size_t i = 0; i < a.size(); ++i) groups.join(a[i], b[i]);
    }
    division.counts_.assign(needed.size(), 1);
    for (std::size_t i = 0; i < needed.size(); ++i) {
        int& count = division.counts_[at(groups.rootOf(static_cast<int>(i)))];
        count = std::max(count, needed[i]);
    }
    for (auto& loops : division.stretches_)
        for (auto& edges : loops)
            for (auto& own : edges)
                for (Stretch& stretch : own) stretch.group = groups.rootOf(stretch.group);
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        division.followFacingEdges(input.pieces[p], static_cast<int>(p), boundaries[p],
                                   sewnEdges(input.pieces[p], static_cast<int>(p), seams, arena), arena);
    return division;
}

std::pmr::vector<int> BoundaryDivision::groupsAlong(const SeamChain& chain, Arena& arena) const {
    std::pmr::vector<int> groups(&arena);
    for (const ChainPart& part : chain.parts) {
        const auto first = static_cast<std::ptrdiff_t>(groups.size());
        for (const Stretch& stretch : stretches(part.part.piece, part.part.loop, part.part.edge)) {
            const double middle = 0.5 * (stretch.from + stretch.to);
            if (middle > part.part.from && middle < part.part.to) groups.push_back(stretch.group);
        }
        if (part.part.reversed) std::reverse(groups.begin() + first, groups.end());
    }
    return groups;
}

/// A free straight edge is divided as the sewn one it faces, unless that costs the cells between them too
/// much.
void BoundaryDivision::followFacingEdges(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary,
                                         const SewnEdges& sewn, Arena& arena) {
    if (piece.rule != LineRule::regular || !piece.regions.empty()) return;
    for (const int axis : {0, 1}) {
        const double most = mostPartsAcross(along(boundary.box.high - boundary.box.low, 1 - axis), piece.spacing);
        const std::pmr::vector<GrainSpan> spans = grainSpans(piece, boundary, axis, arena);
        const auto forEachStretch = [&](bool ofSewn, auto use) {
            for (const GrainSpan& span : spans)
                if (static_cast<bool>(sewn[at(span.loop)][at(span.edge)]) == ofSewn)
                    for (const Stretch& stretch : stretches(pieceIndex, span.loop, span.edge))
                        use(std::minmax({span.at(stretch.from), span.at(stretch.to)}), stretch.group);
        };
        forEachStretch(false, [&](std::pair<double, double> own, int group) {
            const int natural = counts_[at(group)];
            forEachStretch(true, [&](std::pair<double, double> facing, int other) {
                if (std::abs(own.first - facing.first) <= samePlace &&
                    std::abs(own.second - facing.second) <= samePlace && counts_[at(other)] <= most * natural)
                    counts_[at(group)] = std::max(counts_[at(group)], counts_[at(other)]);
            });
        });
    }
}

GrainStretches BoundaryDivision::grainStretches(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary,
                                                Arena& arena) const {
    GrainStretches result{std::pmr::vector<GrainStretch>(&arena), std::pmr::vector<GrainStretch>(&arena)};
    for (const int axis : {0, 1})
        for (const GrainSpan& span : grainSpans(piece, boundary, axis, arena))
            for (const Stretch& stretch : stretches(pieceIndex, span.loop, span.edge)) {
                const auto [low, high] = std::minmax({span.at(stretch.from), span.at(stretch.to)});
                result[at(axis)].push_back({low, high, count(stretch)});
            }
    return result;
}

std::span<const Stretch> BoundaryDivision::stretches(int piece, int loop, int edge) const {
    return stretches_[at(piece)][at(loop)][at(edge)];
}

void BoundaryDivision::listFractions(int piece, int loop, int edge, std::pmr::vector<double>& fractions) const {
    fractions.assign({0});
    for (const Stretch& stretch : stretches(piece, loop, edge)) {
        const int n = count(stretch);
        for (int k = 1; k < n; ++k) fractions.push_back(stretch.from + (stretch.to - stretch.from) * k / n);
        fractions.push_back(stretch.to);
    }
}

std::size_t BoundaryDivision::mostNodes(int piece, int loop) const {
    std::size_t most = 1;
    for (const auto& edge : stretches_[at(piece)][at(loop)])
        for (const Stretch& stretch : edge) most += at(count(stretch));
    return most;
}

void BoundaryDivision::describe(int piece, std::pmr::vector<double>& description) const {
    description.clear();
    for (std::size_t loop = 0; loop < stretches_[at(piece)].size(); ++loop)
        for (std::size_t edge = 0; edge < stretches_[at(piece)][loop].size(); ++edge) {
            description.push_back(passed_[at(piece)][loop][edge] ? -1 : -2);
            for (const Stretch& stretch : stretches_[at(piece)][loop][edge])
                description.insert(description.end(), {stretch.from, stretch.to, static_cast<double>(count(stretch))});
        }
}

bool BoundaryDivision::passesEnd(int piece, int loop, int edge) const {
    return passed_[at(piece)][at(loop)][at(edge)];
}

void BoundaryDivision::takeEveryVertex(int piece, int loop) {
    auto& passed = passed_[at(piece)][at(loop)];
    std::fill(passed.begin(), passed.end(), char{0});
}

} // namespace toile::meshing
