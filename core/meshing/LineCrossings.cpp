// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/LineCrossings.h"

#include "core/meshing/MainLines.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

constexpr double leastGap = 1e-3; ///< of the spacing [–]

/// Parameters at which a coordinate of the curve passes one of the lines between two parameters.
void addCrossings(const Curve& curve, const PieceFrame& frame, int axis, std::span<const double> lines, double from,
                  double to, std::pmr::vector<double>& parameters) {
    const auto coordinate = [&](double t) { return along(frame.frameOf(geometry::pointAt(curve, t)), axis); };
    const double start = coordinate(from), end = coordinate(to);
    const auto first = std::lower_bound(lines.begin(), lines.end(), std::min(start, end));
    for (auto line = first; line != lines.end() && *line <= std::max(start, end); ++line) {
        double below = from, above = to;
        for (int halving = 0; halving < 50; ++halving) {
            const double middle = 0.5 * (below + above);
            ((coordinate(middle) < *line) == (start < end) ? below : above) = middle;
        }
        parameters.push_back(0.5 * (below + above));
    }
}

/// Appends the crossings of a curve.
void listCrossings(const Curve& curve, const EdgeArc& arc, const PieceFrame& frame, const MainLines& lines,
                   double spacing, Arena& arena, std::pmr::vector<double>& kept) {
    const int parts = std::holds_alternative<geometry::LineShape>(curve.shape) ? 1 : 256; // curves turn back less often
    std::pmr::vector<double> parameters(&arena);
    for (int k = 0; k < parts; ++k)
        for (const int axis : {0, 1})
            addCrossings(curve, frame, axis, axis == 0 ? lines.x : lines.y, static_cast<double>(k) / parts,
                         static_cast<double>(k + 1) / parts, parameters);
    std::pmr::vector<double> fractions(&arena);
    for (const double t : parameters) fractions.push_back(arc.arc.fractionAt(t));
    std::sort(fractions.begin(), fractions.end());
    const double gap = std::max(leastGap * spacing, 64 * frame.unit) / arc.length;
    for (const double fraction : fractions)
        if (fraction > gap && fraction < 1 - gap && (kept.empty() || fraction - kept.back() > gap))
            kept.push_back(fraction);
}

} // namespace

PiecePoints lineCrossings(const PieceInput& piece, const PieceBoundary& boundary, Arena& arena) {
    const MainLines lines = mainLines(piece, boundary, {}, {}, arena);
    PiecePoints crossings(&arena);
    for (int loop = 0; loop < loopCount(piece); ++loop) {
        auto& edges = crossings.emplace_back();
        for (std::size_t e = 0; e < loopOf(piece, loop).size(); ++e) {
            const EdgeArc& arc = boundary.loops[static_cast<std::size_t>(loop)].edges[e];
            auto& own = edges.emplace_back();
            if (!arc.collapsed)
                listCrossings(loopOf(piece, loop)[e].curve, arc, boundary.frame, lines, piece.spacing, arena, own);
        }
    }
    return crossings;
}

} // namespace toile::meshing
