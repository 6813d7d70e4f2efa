// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/SeamDivision.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

namespace toile::meshing {
namespace {

constexpr double samePlace = 1e-5; ///< fixed points nearer than this along an edge are one [m]
constexpr int mostRounds = 64;

using Breaks =
    std::vector<std::vector<std::vector<std::vector<double>>>>; ///< [piece][loop][edge], rising fractions

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

const EdgeArc& arcOf(const std::vector<PieceBoundary>& boundaries, int piece, int loop, int edge) {
    return boundaries[at(piece)].loops[at(loop)].edges[at(edge)];
}

std::vector<double>& breaksOf(Breaks& breaks, const SeamPartInput& part) {
    return breaks[at(part.piece)][at(part.loop)][at(part.edge)];
}

/// Adds a fixed point unless one is there already; says whether it did.
bool addBreak(std::vector<double>& breaks, double fraction, double edgeLength) {
    const auto above = std::lower_bound(breaks.begin(), breaks.end(), fraction);
    const double tolerance = std::max(1e-12, samePlace / std::max(edgeLength, 1e-9));
    if (above != breaks.end() && *above - fraction <= tolerance) return false;
    if (above != breaks.begin() && fraction - *std::prev(above) <= tolerance) return false;
    breaks.insert(above, fraction);
    return true;
}

Breaks ownBreaks(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                 const std::vector<CheckedSeam>& seams) {
    Breaks breaks;
    for (std::size_t p = 0; p < input.pieces.size(); ++p) {
        auto& loops = breaks.emplace_back();
        for (int loop = 0; loop < loopCount(input.pieces[p]); ++loop) {
            auto& edges = loops.emplace_back();
            for (std::size_t e = 0; e < loopOf(input.pieces[p], loop).size(); ++e) {
                auto& own = edges.emplace_back(std::vector<double>{0, 1});
                const EdgeArc& arc = boundaries[p].loops[at(loop)].edges[e];
                if (arc.collapsed) continue;
                for (const double notch : loopOf(input.pieces[p], loop)[e].notches)
                    addBreak(own, notch, arc.length);
            }
        }
    }
    for (const CheckedSeam& seam : seams)
        for (const SeamChain& side : seam.sides)
            for (const ChainPart& part : side.parts)
                for (const double end : {part.part.from, part.part.to})
                    addBreak(breaksOf(breaks, part.part), end,
                             arcOf(boundaries, part.part.piece, part.part.loop, part.part.edge).length);
    return breaks;
}

/// The fixed points of a part in walking order, as fractions of its edge; both ends included.
std::vector<double> breaksAlong(const std::vector<double>& breaks, const ChainPart& part, double edgeLength) {
    const double tolerance = samePlace / edgeLength;
    std::vector<double> along;
    for (const double fraction : breaks)
        if (fraction >= part.part.from - tolerance && fraction <= part.part.to + tolerance)
            along.push_back(fraction);
    if (part.part.reversed) std::reverse(along.begin(), along.end());
    return along;
}

/// Carries the fixed points of one side of a seam to the other; says whether anything was new.
bool carryAcross(const CheckedSeam& seam, int side, const std::vector<PieceBoundary>& boundaries,
                 Breaks& breaks) {
    bool added = false;
    const SeamChain& other = seam.sides[at(1 - side)];
    for (const ChainPart& part : seam.sides[at(side)].parts) {
        const double edgeLength = arcOf(boundaries, part.part.piece, part.part.loop, part.part.edge).length;
        for (const double fraction : breaksAlong(breaksOf(breaks, part.part), part, edgeLength)) {
            const double chain =
                seam.across(side, std::clamp(part.chainOf(fraction), part.start, part.start + part.length));
            for (const ChainPart& target : other.parts) {
                if (chain < target.start + samePlace || chain > target.start + target.length - samePlace)
                    continue;
                const EdgeArc& arc = arcOf(boundaries, target.part.piece, target.part.loop, target.part.edge);
                added |= addBreak(breaksOf(breaks, target.part), target.fractionOf(chain), arc.length);
            }
        }
    }
    return added;
}

/// Disjoint sets of stretches that must carry equal counts.
struct Groups {
    std::vector<int> parent;
    int rootOf(int i) {
        while (parent[at(i)] != i) i = parent[at(i)] = parent[at(parent[at(i)])];
        return i;
    }
    void join(int a, int b) { parent[at(rootOf(a))] = rootOf(b); }
};

std::vector<int> groupsAlong(const SeamChain& chain,
                             const std::vector<std::vector<std::vector<std::vector<Stretch>>>>& stretches) {
    std::vector<int> groups;
    for (const ChainPart& part : chain.parts) {
        std::vector<int> own;
        for (const Stretch& stretch :
             stretches[at(part.part.piece)][at(part.part.loop)][at(part.part.edge)]) {
            const double middle = 0.5 * (stretch.from + stretch.to);
            if (middle > part.part.from && middle < part.part.to) own.push_back(stretch.group);
        }
        if (part.part.reversed) std::reverse(own.begin(), own.end());
        groups.insert(groups.end(), own.begin(), own.end());
    }
    return groups;
}

constexpr double shortEdge = 0.25; ///< of the spacing; longer edges keep their ends [–]
constexpr double sharpTurn = 15 * std::numbers::pi / 180;      ///< a corner [rad]
constexpr double largestRunTurn = 30 * std::numbers::pi / 180; ///< between two nodes of a run [rad]

double turnBetween(const Curve& in, const Curve& out) {
    const Vec2 a = in.end - in.start, b = out.end - out.start;
    return std::abs(std::atan2(cross(a, b), dot(a, b)));
}

/// Which ends of edges of a loop are no nodes: those inside smooth runs of short free lines, but for one per
/// spacing.
std::vector<char> passedEnds(const BoundaryLoop& edges, const LoopBoundary& arcs,
                             const std::vector<char>& sewn, double spacing) {
    const std::size_t n = edges.size();
    std::vector<char> passed(n, 0);
    const auto isShort = [&](std::size_t e) {
        return !sewn[e] && !arcs.edges[e].collapsed && edges[e].notches.empty() &&
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
    return passed;
}

} // namespace

Result<BoundaryDivision> BoundaryDivision::create(const MeshInput& input,
                                                  const std::vector<PieceBoundary>& boundaries,
                                                  const std::vector<CheckedSeam>& seams,
                                                  const SpacingAlong& spacing) {
    Breaks breaks = ownBreaks(input, boundaries, seams);
    bool changed = true;
    for (int round = 0; changed; ++round) {
        changed = false;
        for (std::size_t s = 0; s < seams.size(); ++s) {
            const bool added =
                carryAcross(seams[s], 0, boundaries, breaks) | carryAcross(seams[s], 1, boundaries, breaks);
            if (added && round >= mostRounds)
                return fail(ErrorCode::invalidInput,
                            "The seam carries its own points on and on along the same edges; seams that "
                            "share an edge do not fit together.",
                            {.object = nameOf(input.seams[s])});
            changed |= added;
        }
    }

    BoundaryDivision division;
    Groups groups;
    std::vector<int> needed;
    for (std::size_t p = 0; p < breaks.size(); ++p) {
        auto& loops = division.stretches_.emplace_back();
        for (std::size_t loop = 0; loop < breaks[p].size(); ++loop) {
            auto& edges = loops.emplace_back();
            for (std::size_t e = 0; e < breaks[p][loop].size(); ++e) {
                auto& own = edges.emplace_back();
                const std::vector<double>& places = breaks[p][loop][e];
                const EdgeArc& arc = boundaries[p].loops[loop].edges[e];
                for (std::size_t i = 0; i + 1 < places.size(); ++i) {
                    const int group = static_cast<int>(needed.size());
                    own.push_back({places[i], places[i + 1], group});
                    const double length = arc.length * (places[i + 1] - places[i]);
                    const double finest = spacing(static_cast<int>(p), static_cast<int>(loop),
                                                  static_cast<int>(e), places[i], places[i + 1]);
                    needed.push_back(
                        arc.collapsed ? 1 : std::max(1, static_cast<int>(std::ceil(length / finest - 1e-9))));
                    groups.parent.push_back(group);
                }
            }
        }
    }
    division.passed_.resize(input.pieces.size());
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        for (int loop = 0; loop < loopCount(input.pieces[p]); ++loop) {
            const BoundaryLoop& edges = loopOf(input.pieces[p], loop);
            std::vector<char> sewn(edges.size(), 0);
            for (const CheckedSeam& seam : seams)
                for (const SeamChain& side : seam.sides)
                    for (const ChainPart& part : side.parts)
                        if (part.part.piece == static_cast<int>(p) && part.part.loop == loop)
                            sewn[at(part.part.edge)] = 1;
            division.passed_[p].push_back(
                passedEnds(edges, boundaries[p].loops[at(loop)], sewn, input.pieces[p].spacing));
        }
    for (std::size_t s = 0; s < seams.size(); ++s) {
        const std::vector<int> a = groupsAlong(seams[s].sides[0], division.stretches_);
        const std::vector<int> b = groupsAlong(seams[s].sides[1], division.stretches_);
        if (a.size() != b.size())
            return fail(ErrorCode::invalidInput,
                        "Fixed points of the two sides lie too near one another to be paired.",
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
    return division;
}

const std::vector<Stretch>& BoundaryDivision::stretches(int piece, int loop, int edge) const {
    return stretches_[at(piece)][at(loop)][at(edge)];
}

std::vector<double> BoundaryDivision::fractions(int piece, int loop, int edge) const {
    std::vector<double> result{0};
    for (const Stretch& stretch : stretches(piece, loop, edge)) {
        const int n = count(stretch);
        for (int k = 1; k < n; ++k) result.push_back(stretch.from + (stretch.to - stretch.from) * k / n);
        result.push_back(stretch.to);
    }
    return result;
}

bool BoundaryDivision::passesEnd(int piece, int loop, int edge) const {
    return passed_[at(piece)][at(loop)][at(edge)];
}

void BoundaryDivision::takeEveryVertex(int piece, int loop) {
    auto& passed = passed_[at(piece)][at(loop)];
    std::fill(passed.begin(), passed.end(), char{0});
}

} // namespace toile::meshing
