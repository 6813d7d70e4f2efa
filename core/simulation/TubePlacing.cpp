// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/TubePlacing.h"

#include "core/pattern/PatternMeasures.h"

#include <algorithm>
#include <numbers>

namespace toile::simulation {
namespace {

constexpr double step = 0.01;      // of the bent line [m]
constexpr double straight = 0.001; // a line that keeps within this is not bent [m]

/// Coordinates of a point in a rigid frame.
Vec3 seenFrom(const Transform& frame, const Vec3& point) {
    const Vec3 d = point - frame.origin;
    return {dot(d, frame.axisX), dot(d, frame.axisY), dot(d, frame.axisZ)};
}

/// The frame of a piece whose origin lies on the skin of the tube, of which `limb` is the frame on the limb's
/// line.
Transform pieceFrame(const Transform& limb, const TubePlace& place) {
    const Vec3& along = limb.axisY;
    const Vec3 upper = normalized(place.upper - along * dot(place.upper, along));
    const double turn = place.middle / place.radius; // from the piece's origin to its middle
    const Vec3 outward = upper * std::cos(turn) - cross(along, upper) * std::sin(turn);
    const Vec3 across = cross(along, outward);
    const Vec2 a = place.axis, b = acrossOf(a);
    return {across * b.x + along * a.x, across * b.y + along * a.y, outward, limb.origin + outward * place.radius};
}

} // namespace

pattern::Placement placedRound(const geometry::Polyline& limb, const TubePlace& place, double low, double high) {
    geometry::Polyline line = limb;
    double at = place.at;
    if (!place.towardsEnd) {
        std::ranges::reverse(line);
        at = geometry::arcLength(line) - at;
    }
    pattern::Placement placement{pieceFrame(geometry::frameAlong(line, at, place.upper), place),
                                 pattern::Curl{place.axis, place.radius}};
    pattern::BentLine bent{low - step, {}}; // a step beyond both ends, so that directions are right there too
    double off = 0;
    const int parts = std::max(1, static_cast<int>(std::ceil((high - low) / step))) + 2;
    for (int i = 0; i <= parts; ++i) {
        const double along = low - step + (high - low + 2 * step) * i / parts;
        const Vec3 p = seenFrom(placement.transform, geometry::frameAlong(line, at + along, place.upper).origin) +
                       Vec3{0, 0, place.radius};
        off = std::max(off, geometry::distance(p, Vec3{place.axis.x, place.axis.y, 0} * along));
        bent.points.push_back(p);
    }
    if (off > straight) placement.curl->bent = std::move(bent);
    return placement;
}

std::vector<Vec2> pointsOn(const pattern::Piece& piece) {
    constexpr double apart = 0.015; // [m]
    const geometry::Polygon outline = pattern::flattened(piece.outline, 1e-3);
    std::vector<Vec2> points;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        const int parts = 1 + static_cast<int>(geometry::distance(a, b) / apart);
        for (int k = 0; k < parts; ++k) points.push_back(lerp(a, b, static_cast<double>(k) / parts));
    }
    const geometry::Box2 box = geometry::boundsOf(outline);
    for (double y = box.low.y; y < box.high.y; y += apart)
        for (double x = box.low.x; x < box.high.x; x += apart)
            if (geometry::windingNumber(outline, {x, y}) != 0) points.push_back({x, y});
    return points;
}

Extent extentAlong(const std::vector<Vec2>& points, Vec2 direction) {
    const auto [low, high] = std::ranges::minmax(points, {}, [&](Vec2 p) { return dot(p, direction); });
    return {dot(low, direction), dot(high, direction)};
}

bool isTube(const std::vector<Vec2>& points, const pattern::Placement& placement) {
    if (!placement.curl) return false;
    const Extent across = extentAlong(points, acrossOf(placement.curl->axis));
    return across.high - across.low > std::numbers::pi * std::abs(placement.curl->radius);
}

} // namespace toile::simulation
