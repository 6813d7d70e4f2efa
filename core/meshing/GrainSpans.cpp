// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/GrainSpans.h"

#include <algorithm>
#include <cmath>

namespace toile::meshing {
namespace {

constexpr double leastLineGap = 0.5; ///< of the spacing: fixed points nearer than this cannot both have a line [–]

/// Wishes for one place become one; rising.
void join(std::pmr::vector<LineWish>& wishes, double tolerance) {
    std::sort(wishes.begin(), wishes.end(), [](const LineWish& a, const LineWish& b) { return a.at < b.at; });
    std::size_t kept = 0;
    for (const LineWish& wish : wishes)
        if (kept > 0 && wish.at - wishes[kept - 1].at <= tolerance) wishes[kept - 1].weight += wish.weight;
        else wishes[kept++] = wish;
    wishes.resize(kept);
}

} // namespace

int partsOf(double distance, double spacing) {
    return std::max(1, static_cast<int>(std::ceil(distance / spacing - 1e-9)));
}

std::pmr::vector<GrainSpan> grainSpans(const PieceInput& piece, const PieceBoundary& boundary, int axis, Arena& arena) {
    std::pmr::vector<GrainSpan> spans(&arena);
    for (int loop = 0; loop < loopCount(piece); ++loop)
        for (int e = 0, n = static_cast<int>(loopOf(piece, loop).size()); e < n; ++e) {
            const Curve& curve = loopOf(piece, loop)[static_cast<std::size_t>(e)].curve;
            if (!std::holds_alternative<geometry::LineShape>(curve.shape)) continue;
            const Vec2 a = boundary.frame.frameOf(curve.start), b = boundary.frame.frameOf(curve.end);
            if (std::abs(along(b - a, 1 - axis)) > 2 * boundary.frame.unit) continue;
            const GrainSpan span{loop, e, along(a, axis), along(b, axis)};
            if (span.high() - span.low() >= piece.spacing) spans.push_back(span);
        }
    return spans;
}

GrainStretches grainStretches(const PieceInput& piece, const PieceBoundary& boundary, const PiecePoints& fixedPoints,
                              Arena& arena) {
    GrainStretches stretches{std::pmr::vector<GrainStretch>(&arena), std::pmr::vector<GrainStretch>(&arena)};
    for (const int axis : {0, 1})
        for (const GrainSpan& span : grainSpans(piece, boundary, axis, arena)) {
            const auto& own = fixedPoints[static_cast<std::size_t>(span.loop)][static_cast<std::size_t>(span.edge)];
            for (std::size_t i = 0; i + 1 < own.size(); ++i) {
                const auto [low, high] = std::minmax({span.at(own[i]), span.at(own[i + 1])});
                stretches[static_cast<std::size_t>(axis)].push_back({low, high, partsOf(high - low, piece.spacing)});
            }
        }
    return stretches;
}

double mostPartsAcross(double extentAcross, double spacing) {
    constexpr double band = 4; // spacings
    return extentAcross <= band * spacing ? 2 : 1.5;
}

std::pmr::vector<LineWish> grainLines(const PieceInput& piece, const PieceFrame& frame, int axis, Arena& arena) {
    std::pmr::vector<LineWish> lines(&arena);
    for (int loop = 0; loop < loopCount(piece); ++loop)
        for (const BoundaryEdge& edge : loopOf(piece, loop)) {
            if (!std::holds_alternative<geometry::LineShape>(edge.curve.shape)) continue;
            const Vec2 a = frame.frameOf(edge.curve.start), b = frame.frameOf(edge.curve.end);
            const double length = std::abs(along(b - a, 1 - axis));
            if (std::abs(along(b - a, axis)) > 2 * frame.unit || length <= 4 * frame.unit) continue;
            lines.push_back({0.5 * along(a + b, axis), length});
        }
    for (const FoldInput& fold : piece.folds)
        for (std::size_t i = 0; i + 1 < fold.points.size(); ++i) {
            const Vec2 a = frame.frameOf(fold.points[i]), b = frame.frameOf(fold.points[i + 1]);
            const double length = std::abs(along(b - a, 1 - axis));
            if (std::abs(along(b - a, axis)) <= 2 * frame.unit && length > 4 * frame.unit)
                lines.push_back({0.5 * along(a + b, axis), length});
        }
    join(lines, 2 * frame.unit);
    std::sort(lines.begin(), lines.end(), [&](const LineWish& a, const LineWish& b) {
        return std::abs(a.weight - b.weight) > frame.unit ? a.weight > b.weight : a.at < b.at;
    });
    return lines;
}

std::pmr::vector<double> linePlaces(const PieceInput& piece, const PieceFrame& frame, int axis,
                                    std::span<const GrainStretch> stretches, Arena& arena) {
    std::pmr::vector<LineWish> wishes = grainLines(piece, frame, axis, arena);
    for (const GrainStretch& stretch : stretches)
        for (const double end : {stretch.low, stretch.high})
            wishes.push_back({end, 0.5 * (stretch.high - stretch.low)});
    join(wishes, 2 * frame.unit);
    for (LineWish& wish : wishes) wish.weight = std::round(wish.weight / (64 * frame.unit)); // rounding decides nothing
    std::sort(wishes.begin(), wishes.end(), [](const LineWish& a, const LineWish& b) {
        return a.weight != b.weight ? a.weight > b.weight : a.at < b.at;
    });
    const double least = leastLineGap * piece.spacing;
    std::pmr::vector<double> places(&arena);
    for (const LineWish& wish : wishes) {
        const auto above = std::lower_bound(places.begin(), places.end(), wish.at);
        const bool crowded = (above != places.end() && *above - wish.at < least) ||
                             (above != places.begin() && wish.at - *std::prev(above) < least);
        if (!crowded) places.insert(above, wish.at);
    }
    return places;
}

} // namespace toile::meshing
