// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/PieceBoundary.h"

#include "core/meshing/BorderSpacing.h"
#include "core/meshing/Crossings.h"
#include "core/meshing/FoldNodes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace toile::meshing {
namespace {

constexpr double largestCoordinate = 1e6; ///< [m]
constexpr double joinTolerance = 1e-6;    ///< an edge starts where the one before ends [m]
constexpr double largestCellCount = 1e7;

/// A flattened contour and the edge each of its segments comes from.
struct Contour {
    std::pmr::vector<GridPoint> points;
    std::pmr::vector<int> edges;
};

tl::unexpected<Error> refuse(const std::string& object, const std::string& sentence) {
    return fail(ErrorCode::invalidInput, sentence, {.object = object});
}

bool isUsable(Vec2 point) {
    return geometry::isFinite(point) && std::abs(point.x) < largestCoordinate && std::abs(point.y) < largestCoordinate;
}

bool isUsable(const Curve& curve) {
    if (const auto* cubic = std::get_if<geometry::CubicShape>(&curve.shape))
        if (!isUsable(cubic->control1) || !isUsable(cubic->control2)) return false;
    if (const auto* arc = std::get_if<geometry::ArcShape>(&curve.shape))
        if (!(std::abs(arc->bulge) < 1e6)) return false;
    return isUsable(curve.start) && isUsable(curve.end);
}

std::optional<Error> settingError(const PieceInput& piece) {
    const auto error = [&](const std::string& text) {
        return Error{ErrorCode::invalidInput, text, {.object = nameOf(piece)}};
    };
    if (!std::isfinite(piece.spacing) || piece.spacing <= 0)
        return error("The spacing must be a positive number of metres.");
    if (!std::isfinite(piece.grain)) return error("The direction of the grain is not a number.");
    for (const RegionInput& region : piece.regions) {
        if (region.refinement < 0 || region.refinement > 16)
            return error("The refinement of region \"" + region.label + "\" must be between 0 and 16.");
        for (const Vec2 p : region.outline)
            if (!isUsable(p))
                return error("A point of region \"" + region.label + "\" is not a number or beyond 1e6 m.");
        for (const Polygon& hole : region.holes)
            for (const Vec2 p : hole)
                if (!isUsable(p))
                    return error("A point of region \"" + region.label + "\" is not a number or beyond 1e6 m.");
    }
    return std::nullopt;
}

std::optional<Error> edgeError(const PieceInput& piece, int loop) {
    const BoundaryLoop& edges = loopOf(piece, loop);
    const auto error = [&](int e, const std::string& text) {
        return Error{ErrorCode::invalidInput, text, {.object = nameOf(piece, loop, e)}};
    };
    if (edges.empty())
        return Error{ErrorCode::invalidInput, "A border needs at least three points.", {.object = nameOf(piece)}};
    for (int e = 0, n = static_cast<int>(edges.size()); e < n; ++e) {
        const BoundaryEdge& edge = edges[static_cast<std::size_t>(e)];
        if (!isUsable(edge.curve)) return error(e, "A coordinate is not a number or beyond 1e6 m.");
        const Vec2 nextStart = edges[static_cast<std::size_t>((e + 1) % n)].curve.start;
        if (distance(edge.curve.end, nextStart) > joinTolerance)
            return error(e, "The edge ends at " + pointText(edge.curve.end) + ", but the next one starts at " +
                                pointText(nextStart) + ".");
        double before = 0;
        for (const double notch : edge.notches) {
            if (!(notch > before && notch < 1)) return error(e, "Notches must rise strictly between 0 and 1.");
            before = notch;
        }
    }
    return std::nullopt;
}

double chordErrorOf(const PieceInput& piece) {
    return std::min(0.02 * piece.spacing, 1e-4);
}

/// Straight edges a–b–a bear no cloth: both go.
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

Contour flattenedContour(const PieceInput& piece, int loop, const PieceFrame& frame, const LoopBoundary& boundary,
                         Arena& arena) {
    Contour contour{std::pmr::vector<GridPoint>(&arena), std::pmr::vector<int>(&arena)};
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

/// Twice the signed area in units², in double: good to its rounding, exact zero for collinear points.
double doubledArea(std::span<const GridPoint> ring) {
    WideInt sum = 0;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) sum += orientation(ring[0], ring[i], ring[i + 1]);
    return static_cast<double>(sum);
}

void turnRound(Contour& contour) {
    std::reverse(contour.points.begin(), contour.points.end());
    std::reverse(contour.edges.begin(), contour.edges.end());
    std::rotate(contour.edges.begin(), contour.edges.begin() + 1, contour.edges.end());
}

Vec2 meetingPoint(const PieceFrame& frame, const RingSegment& s, const RingSegment& t) {
    GridPoint at = s.a;
    const double da = static_cast<double>(orientation(t.a, t.b, s.a));
    const double db = static_cast<double>(orientation(t.a, t.b, s.b));
    if (onSegment(t.a, t.b, s.b)) at = s.b;
    else if (onSegment(s.a, s.b, t.a)) at = t.a;
    else if (onSegment(s.a, s.b, t.b)) at = t.b;
    Vec2 point{static_cast<double>(at.x), static_cast<double>(at.y)};
    if (da * db < 0)
        point = lerp(Vec2{static_cast<double>(s.a.x), static_cast<double>(s.a.y)},
                     Vec2{static_cast<double>(s.b.x), static_cast<double>(s.b.y)}, da / (da - db));
    return frame.pointFromFrame(point * frame.unit);
}

std::optional<Error> crossingError(const PieceInput& piece, const PieceFrame& frame, std::span<const Contour> contours,
                                   Arena& arena) {
    std::pmr::vector<RingSegment> segments(&arena);
    for (std::size_t loop = 0; loop < contours.size(); ++loop) {
        const std::size_t first = segments.size();
        appendSegments(contours[loop].points, static_cast<int>(loop), segments);
        for (std::size_t i = first; i < segments.size(); ++i) segments[i].edge = contours[loop].edges[i - first];
    }
    const auto pair = firstCrossing(segments, arena);
    if (!pair) return std::nullopt;
    const RingSegment &s = segments[static_cast<std::size_t>(pair->first)],
                      &t = segments[static_cast<std::size_t>(pair->second)];
    const std::string where = pointText(meetingPoint(frame, s, t));
    const std::string other = nameOf(piece, t.ring, t.edge);
    return Error{ErrorCode::invalidInput,
                 s.ring == t.ring ? "The border crosses or touches itself at " + where + ", with " + other + "."
                                  : "Two borders cross or touch at " + where + ", with " + other + ".",
                 {.object = nameOf(piece, s.ring, s.edge)}};
}

std::optional<Error> nestingError(const PieceInput& piece, std::span<const Contour> contours) {
    for (std::size_t h = 1; h < contours.size(); ++h) {
        const GridPoint corner = contours[h].points.front();
        const auto error = [&](const std::string& lies) {
            return Error{ErrorCode::invalidInput, "Hole " + std::to_string(h) + lies, {.object = nameOf(piece)}};
        };
        if (!isInside(contours[0].points, corner)) return error(" lies outside the piece.");
        for (std::size_t other = 1; other < contours.size(); ++other)
            if (other != h && isInside(contours[other].points, corner))
                return error(" lies inside hole " + std::to_string(other) + ".");
    }
    return std::nullopt;
}

std::optional<Error> sizeError(const PieceInput& piece, const PieceBoundary& boundary) {
    double regionArea = 0;
    for (const RegionInput& region : piece.regions)
        regionArea += std::abs(geometry::signedArea(region.outline)) * (std::pow(4.0, region.refinement) - 1);
    const Vec2 extent = boundary.box.high - boundary.box.low;
    const double square = piece.spacing * piece.spacing;
    double cells = (boundary.area + std::min(regionArea, boundary.area * 4e9)) / square;
    cells = std::max(cells, (extent.x / piece.spacing + 2) * (extent.y / piece.spacing + 2) / 4);
    double length = 0;
    for (const LoopBoundary& loop : boundary.loops)
        for (const EdgeArc& edge : loop.edges) length += edge.length;
    cells = std::max(cells, length / piece.spacing);
    if (cells <= largestCellCount) return std::nullopt;
    char estimate[32];
    std::snprintf(estimate, sizeof estimate, "%.2g", cells);
    return Error{ErrorCode::tooLarge,
                 std::string("The spacing would give about ") + estimate +
                     " cells; at most 1e7 are allowed. Choose a larger spacing.",
                 {.object = nameOf(piece)}};
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

namespace {

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

    std::pmr::vector<Contour> contours(&arena);
    double area = 0;
    for (int loop = 0; loop < loopCount(piece); ++loop) {
        LoopBoundary& edges = boundary.loops[static_cast<std::size_t>(loop)];
        dropSpikes(piece, loop, boundary.frame, arena, edges);
        Contour contour = flattenedContour(piece, loop, boundary.frame, edges, arena);
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
