// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/BoundaryErrors.h"

#include "core/meshing/Crossings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace toile::meshing {
namespace {

constexpr double largestCoordinate = 1e6; ///< [m]
constexpr double joinTolerance = 1e-6;    ///< an edge starts where the one before ends [m]
constexpr double largestCellCount = 1e7;

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

} // namespace

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
        double before = -1;
        for (const double notch : edge.notches) {
            if (!(notch >= 0 && notch > before && notch <= 1))
                return error(e, "Notches must rise strictly, from 0 to 1.");
            before = notch;
        }
    }
    return std::nullopt;
}

std::optional<Error> crossingError(const PieceInput& piece, const PieceFrame& frame,
                                   std::span<const FlatContour> contours, Arena& arena) {
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

std::optional<Error> nestingError(const PieceInput& piece, std::span<const FlatContour> contours) {
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

} // namespace toile::meshing
