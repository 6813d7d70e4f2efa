// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/DividedBorders.h"

#include "core/meshing/BorderSpacing.h"

#include <algorithm>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Doubling where parts of the border run too near one another ends at so many nodes of a piece, and so many
/// times those it began with.
constexpr std::size_t mostBorderNodes = 100000, mostTimesNodes = 16;

/// Doubles each stretch once, however many of its segments are too coarse. False where parts are shorter than the
/// integer grid's unit: more of them make no more nodes.
bool refineOnce(const std::vector<BoundarySpot>& spots, int piece, const PieceBoundary& boundary,
                BoundaryDivision& division) {
    std::vector<int> done;
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

Result<DividedBorders> dividedBorders(const MeshInput& input, const std::vector<PieceBoundary>& boundaries,
                                      const std::vector<CheckedSeam>& seams, const FixedPoints& points,
                                      const SpacingAlong& spacing, const std::vector<const FrozenBorder*>& known) {
    auto created = BoundaryDivision::create(input, boundaries, seams, points, spacing);
    if (!created) return tl::unexpected(created.error());
    DividedBorders result{std::move(*created), {}};
    const BoundaryDivision& division = result.division;
    if (auto apart = nodesApart(input, boundaries, division); !apart) return tl::unexpected(apart.error());
    result.borders.resize(input.pieces.size());
    std::vector<std::size_t> firstCounts(input.pieces.size(), 0);
    std::vector<double> description;
    for (bool coarse = true; coarse;) {
        coarse = false;
        for (std::size_t p = 0; p < input.pieces.size(); ++p) {
            std::optional<FrozenBorder>& border = result.borders[p];
            division.describe(static_cast<int>(p), description);
            if (border && border->description == description) continue;
            if (known[p] && known[p]->description == description) {
                if (firstCounts[p] == 0) firstCounts[p] = known[p]->nodes.points.size();
                border.reset();
                continue;
            }
            border = FrozenBorder{
                description, boundaryNodes(input.pieces[p], static_cast<int>(p), boundaries[p], division), {}};
            const std::size_t count = border->nodes.points.size();
            if (firstCounts[p] == 0) firstCounts[p] = count;
            const std::vector<BoundarySpot> spots = spotsTooCoarse(border->nodes);
            if (spots.empty()) continue;
            coarse = true;
            if (count > std::max(mostBorderNodes, mostTimesNodes * firstCounts[p]) ||
                !refineOnce(spots, static_cast<int>(p), boundaries[p], result.division))
                return fail(ErrorCode::invalidInput,
                            "Two parts of the border run too near one another to be divided into nodes.",
                            {.object = nameOf(input.pieces[p], spots.front().loop, spots.front().edge)});
        }
    }
    for (std::size_t p = 0; p < input.pieces.size(); ++p)
        if (result.borders[p])
            result.borders[p]->seeds =
                seedsOf(result.borders[p]->nodes, boundaries[p].frame, static_cast<int>(p), division);
    return result;
}

} // namespace toile::meshing
