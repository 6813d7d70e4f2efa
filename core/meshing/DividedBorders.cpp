// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/DividedBorders.h"
#include "core/base/Index.h"

#include "core/meshing/BorderSpacing.h"

#include <algorithm>

namespace toile::meshing {
namespace {

/// Doubling where parts of the border run too near one another ends at so many nodes of a piece, and so many
/// times those it began with.
constexpr std::size_t mostBorderNodes = 100000, mostTimesNodes = 16;

/// Doubles each stretch once, however many of its segments are too coarse. False where parts are shorter than the
/// integer grid's unit: more of them make no more nodes.
bool refineOnce(std::span<const BoundarySpot> spots, int piece, const PieceBoundary& boundary, Arena& arena,
                BoundaryDivision& division) {
    std::pmr::vector<int> done(&arena);
    for (const BoundarySpot& spot : spots) {
        division.takeEveryVertex(piece, spot.loop);
        for (const Stretch& stretch : division.stretches(piece, spot.loop, spot.edge)) {
            if (spot.fraction < stretch.from || spot.fraction > stretch.to) continue;
            if (std::find(done.begin(), done.end(), stretch.group) != done.end()) continue;
            done.push_back(stretch.group);
            const double length = boundary.loops[at(spot.loop)].edges[at(spot.edge)].length;
            if (length * (stretch.to - stretch.from) < division.count(stretch) * boundary.frame.unit) return false;
            division.refine(stretch.group);
        }
    }
    return true;
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

} // namespace

Result<BoundaryDivision> divideBorders(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                                       std::span<const CheckedSeam> seams, const FixedPoints& points,
                                       const SpacingAlong& spacing, Arena& arena,
                                       std::span<BorderMemory* const> borders) {
    auto created = BoundaryDivision::create(input, boundaries, seams, points, spacing, arena);
    if (!created) return created;
    BoundaryDivision& division = *created;
    if (auto apart = nodesApart(input, boundaries, division); !apart) return tl::unexpected(apart.error());
    for (BorderMemory* border : borders) border->isNext = false;
    std::pmr::vector<std::size_t> firstCounts(input.pieces.size(), 0, &arena);
    std::pmr::vector<double> description(&arena);
    for (bool coarse = true; coarse;) {
        coarse = false;
        for (std::size_t p = 0; p < input.pieces.size(); ++p) {
            BorderMemory& border = *borders[p];
            division.describe(static_cast<int>(p), description);
            if (border.isNext && border.next.description == description) continue;
            border.isNext = !border.isKnown || border.known.description != description;
            if (!border.isNext) {
                if (firstCounts[p] == 0) firstCounts[p] = border.known.nodes.points.size();
                continue;
            }
            border.next.description = description;
            freezeNodes(input.pieces[p], static_cast<int>(p), boundaries[p], division, arena, border.next.nodes);
            const std::size_t count = border.next.nodes.points.size();
            if (firstCounts[p] == 0) firstCounts[p] = count;
            const std::pmr::vector<BoundarySpot> spots = spotsTooCoarse(border.next.nodes, arena);
            if (spots.empty()) continue;
            coarse = true;
            if (count > std::max(mostBorderNodes, mostTimesNodes * firstCounts[p]) ||
                !refineOnce(spots, static_cast<int>(p), boundaries[p], arena, division))
                return fail(ErrorCode::invalidInput,
                            "Two parts of the border run too near one another to be divided into nodes.",
                            {.object = nameOf(input.pieces[p], spots.front().loop, spots.front().edge)});
        }
    }
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        if (FrozenBorder& next = borders[p]->next; borders[p]->isNext)
            listSeeds(next.nodes, boundaries[p].frame, static_cast<int>(p), division, next.seeds);
    return created;
}

} // namespace toile::meshing
