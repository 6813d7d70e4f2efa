// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Arrange.h"

#include "core/body/Arrangement.h"
#include "core/collision/BodySurface.h"
#include "core/pattern/PatternMeasures.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace toile::simulation {
namespace {

using body::Limb;
using body::LimbAxis;

double distanceTo(const LimbAxis& axis, const Vec3& p) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < axis.points.size(); ++i) {
        const Vec3 a = axis.points[i], along = axis.points[i + 1] - a;
        const double t = std::clamp(dot(p - a, along) / std::max(squaredLength(along), 1e-12), 0.0, 1.0);
        best = std::min(best, geometry::distance(p, a + along * t));
    }
    return best;
}

Vec3 middleOf(const pattern::Piece& piece) {
    Vec3 sum;
    for (const pattern::Vertex& vertex : piece.outline.vertices) sum += pattern::placed(*piece.placement, vertex.position);
    return sum / static_cast<double>(std::max<std::size_t>(1, piece.outline.vertices.size()));
}

Limb nearestLimb(const body::Body& body, const Vec3& p) {
    return std::ranges::min_element(body.axes, {}, [&](const LimbAxis& axis) { return distanceTo(axis, p); })->limb;
}

/// As placementCarriedOver; where the limb's section cannot be measured, as where it bends, without a change of size.
std::optional<Transform> carried(const Transform& placement, const body::Body& from, const body::Body& to, Limb limb) {
    if (const auto whole = body::placementCarriedOver(placement, from, to, limb)) return whole;
    const auto start = body::limbFrame(from, limb), end = body::limbFrame(to, limb);
    if (!start || !end) return std::nullopt;
    const Transform turned{{start->axisX.x, start->axisY.x, start->axisZ.x}, {start->axisX.y, start->axisY.y, start->axisZ.y},
                           {start->axisX.z, start->axisY.z, start->axisZ.z}, {}};
    const Transform back{turned.axisX, turned.axisY, turned.axisZ, -turned.direction(start->origin)};
    return composed(*end, composed(back, placement));
}

/// Points all over a piece.
std::vector<Vec2> pointsOn(const pattern::Piece& piece) {
    constexpr double step = 0.015; // [m]
    const geometry::Polygon outline = pattern::flattened(piece.outline, 1e-3);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        const int parts = 1 + static_cast<int>(geometry::distance(a, b) / step);
        for (int k = 0; k < parts; ++k) points.push_back(lerp(a, b, static_cast<double>(k) / parts));
    }
    const geometry::Box2 box = geometry::boundsOf(outline);
    for (double y = box.low.y; y < box.high.y; y += step)
        for (double x = box.low.x; x < box.high.x; x += step)
            if (geometry::windingNumber(outline, {x, y}) != 0) points.push_back({x, y});
    return points;
}

bool isClear(const std::vector<Vec2>& points, const pattern::Placement& placement, const collision::BodySurface& body) {
    constexpr double clearance = 0.006; // twice the skin offset [m]
    constexpr double depth = 0.2;       // no piece starts deeper in a body [m]
    return std::ranges::none_of(points, [&](Vec2 point) {
        const auto nearest = body.nearest(pattern::placed(placement, point), depth);
        return nearest && nearest->signedDistance < clearance;
    });
}

/// It wraps a limb more than half way round.
bool isTube(const std::vector<Vec2>& points, const pattern::Placement& placement) {
    if (!placement.curl) return false;
    const Vec2 across = geometry::leftOf(placement.curl->axis);
    const auto [low, high] = std::ranges::minmax(points, {}, [&](Vec2 p) { return dot(p, across); });
    return dot(high - low, across) > std::numbers::pi * placement.curl->radius;
}

/// Moved outward, or as a tube widened about its middle, until it is clear of the body; as it was if that does not help.
pattern::Placement cleared(const pattern::Piece& piece, const collision::BodySurface& body) {
    constexpr double step = 0.005, farthest = 0.15; // [m]
    const std::vector<Vec2> points = pointsOn(piece);
    for (double way = 0; way <= farthest; way += step) {
        pattern::Placement moved = *piece.placement;
        moved.transform.origin += moved.transform.axisZ * way;
        if (isTube(points, *piece.placement)) moved.curl->radius += way;
        if (isClear(points, moved, body)) return moved;
    }
    return *piece.placement;
}

} // namespace

pattern::Pattern arrangedOn(const pattern::Pattern& pattern, const body::Body& from, const body::Body& to) {
    if (from.axes.empty() || to.axes.empty()) return pattern;
    pattern::Pattern arranged = pattern;
    for (auto& shared : arranged.pieces) {
        if (!shared->placement) continue;
        const Limb limb = nearestLimb(from, middleOf(pattern::resolved(pattern, *shared)));
        const auto transform = carried(shared->placement->transform, from, to, limb);
        if (!transform) continue;
        pattern::Piece piece = *shared;
        piece.placement->transform = *transform;
        // Rolled tighter than it was, a piece that nearly closes would overlap itself.
        if (piece.placement->curl) piece.placement->curl->radius *= std::max(1.0, body::sizeRatio(from, to, limb).value_or(1));
        shared = std::move(piece);
    }
    return from == to ? arranged : startingClearOf(arranged, to);
}

pattern::Pattern startingClearOf(const pattern::Pattern& pattern, const body::Body& body) {
    const auto surface = collision::BodySurface::create(body.mesh);
    if (!surface) return pattern;
    pattern::Pattern arranged = pattern;
    for (auto& shared : arranged.pieces) {
        if (!shared->placement) continue;
        pattern::Piece piece = *shared;
        piece.placement = cleared(pattern::resolved(pattern, piece), *surface);
        shared = std::move(piece);
    }
    return arranged;
}

} // namespace toile::simulation
