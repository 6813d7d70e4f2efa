// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/SewnNodes.h"
#include "core/base/Index.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace toile::meshing {
namespace {

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

/// The nodes of an edge that a seam walks along between two fixed points.
struct SewnStretch {
    int piece = 0;
    std::span<const EdgeNode> nodes;
    bool reversed = false;

    [[nodiscard]] NodeRef operator[](std::size_t i) const {
        return {piece, nodes[reversed ? nodes.size() - 1 - i : i].node};
    }
};

std::pmr::vector<SewnStretch> sewnStretches(const SeamChain& side, const BoundaryDivision& division,
                                            const std::vector<PieceMesh>& pieces, Arena& arena) {
    std::pmr::vector<SewnStretch> sewn(&arena);
    for (const ChainPart& part : side.parts) {
        const SeamPartInput& where = part.part;
        const EdgeNodes& edge = pieces[at(where.piece)].loops[at(where.loop)][at(where.edge)];
        const auto first = static_cast<std::ptrdiff_t>(sewn.size());
        for (const Stretch& stretch : division.stretches(where.piece, where.loop, where.edge)) {
            const double middle = 0.5 * (stretch.from + stretch.to);
            if (middle < where.from || middle > where.to) continue;
            const auto begin = std::find_if(
                edge.begin(), edge.end(), [&](const EdgeNode& node) { return node.fraction >= stretch.from - 1e-12; });
            const auto end = std::find_if(begin, edge.end(),
                                          [&](const EdgeNode& node) { return node.fraction > stretch.to + 1e-12; });
            sewn.push_back({where.piece, {begin, end}, where.reversed});
        }
        if (where.reversed) std::reverse(sewn.begin() + first, sewn.end());
    }
    return sewn;
}

} // namespace

void sew(const CheckedSeam& seam, const BoundaryDivision& division, const std::vector<PieceMesh>& pieces, Arena& arena,
         SeamNodes& nodes) {
    const std::pmr::vector<SewnStretch> a = sewnStretches(seam.sides[0], division, pieces, arena),
                                        b = sewnStretches(seam.sides[1], division, pieces, arena);
    nodes.pairs.clear();
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t k = 0; k < a[i].nodes.size(); ++k) {
            const std::array<NodeRef, 2> pair{a[i][k], b[i][k]};
            if (nodes.pairs.empty() || nodes.pairs.back() != pair) nodes.pairs.push_back(pair);
        }
}

void judgeSeam(const SeamInput& input, const CheckedSeam& seam, const SeamNodes& nodes,
               const BoundaryDivision& division, const std::vector<PieceMesh>& pieces, SeamReport& report) {
    report.label = input.label;
    report.lengthA = seam.sides[0].length;
    report.lengthB = seam.sides[1].length;
    report.ease = seam.ease;
    report.countA = sewingPoints(seam.sides[0], division);
    report.countB = sewingPoints(seam.sides[1], division);
    report.largestSpacingMismatch = largestSpacingMismatch(nodes, pieces);
}

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

} // namespace toile::meshing
