// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/FlatContour.h"

#include <algorithm>

namespace toile::meshing {
namespace {

double chordErrorOf(const PieceInput& piece) {
    return std::min(0.02 * piece.spacing, 1e-4);
}

} // namespace

void dropSpikes(const PieceInput& piece, int loop, const PieceFrame& frame, Arena& arena, LoopBoundary& boundary) {
    const BoundaryLoop& edges = loopOf(piece, loop);
    const auto gridOf = [&](Vec2 p) { return frame.gridOf(frame.frameOf(p)); };
    std::pmr::vector<std::size_t> kept(&arena);
    const auto isReturn = [&](std::size_t first, std::size_t second) {
        const Curve &there = edges[first].curve, &back = edges[second].curve;
        return std::holds_alternative<geometry::LineShape>(there.shape) &&
               std::holds_alternative<geometry::LineShape>(back.shape) && gridOf(there.start) == gridOf(back.end) &&
               gridOf(there.end) == gridOf(back.start);
    };
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (boundary.edges[e].collapsed) continue;
        if (!kept.empty() && isReturn(kept.back(), e)) {
            boundary.edges[kept.back()].collapsed = boundary.edges[e].collapsed = true;
            kept.pop_back();
        } else {
            kept.push_back(e);
        }
    }
    while (kept.size() >= 2 && isReturn(kept.back(), kept.front())) {
        boundary.edges[kept.back()].collapsed = boundary.edges[kept.front()].collapsed = true;
        kept.pop_back();
        kept.erase(kept.begin());
    }
}

FlatContour flattenedContour(const PieceInput& piece, int loop, const PieceFrame& frame, const LoopBoundary& boundary,
                             Arena& arena) {
    FlatContour contour{std::pmr::vector<GridPoint>(&arena), std::pmr::vector<int>(&arena)};
    const BoundaryLoop& edges = loopOf(piece, loop);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (boundary.edges[e].collapsed) continue;
        const int steps = geometry::flatteningSteps(edges[e].curve, chordErrorOf(piece));
        for (int i = 0; i < steps; ++i) {
            const Vec2 point = geometry::pointAt(edges[e].curve, static_cast<double>(i) / steps);
            const GridPoint p = frame.gridOf(frame.frameOf(point));
            if (!contour.points.empty() && contour.points.back() == p) {
                contour.edges.back() = static_cast<int>(e);
                continue;
            }
            contour.points.push_back(p);
            contour.edges.push_back(static_cast<int>(e));
        }
    }
    while (contour.points.size() > 1 && contour.points.back() == contour.points.front()) {
        contour.points.pop_back();
        contour.edges.pop_back();
    }
    return contour;
}

double doubledArea(std::span<const GridPoint> ring) {
    WideInt sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += orientation(ring[0], ring[i], ring[i + 1]);
    return static_cast<double>(sum);
}

void turnRound(FlatContour& contour) {
    std::reverse(contour.points.begin(), contour.points.end());
    std::reverse(contour.edges.begin(), contour.edges.end());
    std::rotate(contour.edges.begin(), contour.edges.begin() + 1, contour.edges.end());
}

} // namespace toile::meshing
