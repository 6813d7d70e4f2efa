// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PieceBoundary.h"

#include "core/meshing/BorderSpacing.h"
#include "core/meshing/BoundaryErrors.h"
#include "core/meshing/FlatContour.h"
#include "core/meshing/FoldNodes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace toile::meshing {
namespace {

tl::unexpected<Error> refuse(const std::string& object, const std::string& sentence) {
    return fail(ErrorCode::invalidInput, sentence, {.object = object});
}

void measureEdges(const PieceInput& piece, PieceBoundary& boundary) {
    const auto gridOf = [&](Vec2 p) { return boundary.frame.gridOf(boundary.frame.frameOf(p)); };
    boundary.loops.resize(static_cast<std::size_t>(loopCount(piece)));
    for (int loop = 0; loop < loopCount(piece); ++loop) {
        LoopBoundary& edges = boundary.loops[static_cast<std::size_t>(loop)];
        edges.edges.clear();
        for (const BoundaryEdge& edge : loopOf(piece, loop)) {
            EdgeArc arc{geometry::ArcLength(edge.curve), 0, false};
            arc.length = arc.arc.total();
            arc.collapsed = gridOf(edge.curve.start) == gridOf(edge.curve.end) && arc.length < 2 * boundary.frame.unit;
            edges.edges.push_back(arc);
        }
    }
}

} // namespace

std::string nameOf(const PieceInput& piece) {
    return "piece \"" + piece.label + "\"";
}

std::string nameOf(const PieceInput& piece, int loop, int edge) {
    std::string label = loopOf(piece, loop)[static_cast<std::size_t>(edge)].label;
    if (label.empty())
        label = (loop > 0 ? "hole " + std::to_string(loop) + " no. " : "no. ") + std::to_string(edge + 1);
    return nameOf(piece) + ", edge \"" + label + "\"";
}

std::string pointText(Vec2 point) {
    char text[80];
    std::snprintf(text, sizeof text, "(%.1f, %.1f) mm", point.x * 1e3, point.y * 1e3);
    return text;
}

std::string millimetres(double length) {
    char text[40];
    std::snprintf(text, sizeof text, "%.1f mm", length * 1e3);
    return text;
}

std::string micrometres(double length) {
    char text[40];
    std::snprintf(text, sizeof text, "%.2g µm", length * 1e6);
    return text;
}

const BoundaryLoop& loopOf(const PieceInput& piece, int loop) {
    return loop == 0 ? piece.outline : piece.holes[static_cast<std::size_t>(loop - 1)];
}

int loopCount(const PieceInput& piece) {
    return 1 + static_cast<int>(piece.holes.size());
}

Result<void> checkBoundary(const PieceInput& piece, Arena& arena, PieceBoundary& boundary) {
    if (auto error = settingError(piece)) return tl::unexpected(*error);
    std::pmr::vector<Vec2> outlinePoints(&arena);
    for (int loop = 0; loop < loopCount(piece); ++loop) {
        if (auto error = edgeError(piece, loop)) return tl::unexpected(*error);
        for (const BoundaryEdge& edge : loopOf(piece, loop)) {
            outlinePoints.push_back(edge.curve.start);
            if (!std::holds_alternative<geometry::LineShape>(edge.curve.shape))
                for (int k = 1; k < 32; ++k) outlinePoints.push_back(geometry::pointAt(edge.curve, k / 32.0));
        }
    }
    const geometry::Box2 reach = geometry::boundsOf(outlinePoints);
    const double margin = 1.1 * distance(reach.low, reach.high);
    boundary.frame = frameFor(piece.grain, piece.mirrored, outlinePoints, margin);

    measureEdges(piece, boundary);
    boundary.box = boxInFrame(boundary.frame, outlinePoints);
    boundary.area = std::abs(exactArea(piece)); // good enough to refuse by, before anything is flattened
    if (auto error = sizeError(piece, boundary)) return tl::unexpected(*error);

    std::pmr::vector<FlatContour> contours(&arena);
    double area = 0;
    for (int loop = 0; loop < loopCount(piece); ++loop) {
        LoopBoundary& edges = boundary.loops[static_cast<std::size_t>(loop)];
        dropSpikes(piece, loop, boundary.frame, arena, edges);
        FlatContour contour = flattenedContour(piece, loop, boundary.frame, edges, arena);
        if (contour.points.size() < 3)
            return refuse(loop == 0 ? nameOf(piece) : nameOf(piece) + ", hole " + std::to_string(loop),
                          "A border needs at least three different points.");
        const double doubled = doubledArea(contour.points);
        edges.backwards = loop == 0 ? doubled < 0 : doubled > 0;
        if (edges.backwards) turnRound(contour);
        area += std::abs(doubled) * (loop == 0 ? 0.5 : -0.5);
        contours.push_back(std::move(contour));
    }
    if (auto error = crossingError(piece, boundary.frame, contours, arena)) return tl::unexpected(*error);
    for (std::size_t loop = 0; loop < contours.size(); ++loop)
        if (doubledArea(contours[loop].points) == 0) return refuse(nameOf(piece), "The piece has no area.");
    if (auto error = nestingError(piece, contours)) return tl::unexpected(*error);
    if (auto folds = checkFolds(piece, boundary); !folds) return folds;
    boundary.area = area * boundary.frame.unit * boundary.frame.unit;
    if (auto error = sizeError(piece, boundary)) return tl::unexpected(*error);
    std::pmr::vector<Vec2> flat(&arena);
    for (const GridPoint p : contours[0].points)
        flat.push_back(Vec2{static_cast<double>(p.x), static_cast<double>(p.y)} * boundary.frame.unit);
    boundary.box = geometry::boundsOf(flat);
    boundary.contours.resize(contours.size());
    for (std::size_t loop = 0; loop < contours.size(); ++loop)
        boundary.contours[loop].assign(contours[loop].points.begin(), contours[loop].points.end());
    return {};
}

} // namespace toile::meshing
