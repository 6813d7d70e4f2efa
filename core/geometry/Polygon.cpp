// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::geometry {

double signedArea(std::span<const Vec2> polygon) {
    if (polygon.empty()) return 0;
    double doubled = 0;
    const Vec2 origin = polygon.front(); // keeps digits when the polygon lies far from zero
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i)
        doubled += cross(polygon[i] - origin, polygon[(i + 1) % n] - origin);
    return 0.5 * doubled;
}

int windingNumber(std::span<const Vec2> polygon, Vec2 point) {
    int winding = 0;
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i) {
        const Vec2 a = polygon[i], b = polygon[(i + 1) % n];
        if ((a.y <= point.y) == (b.y <= point.y)) continue;
        const double side = cross(b - a, point - a);
        if (a.y <= point.y && side > 0) ++winding;
        if (a.y > point.y && side < 0) --winding;
    }
    return winding;
}

Vec2 closestOnSegment(Vec2 a, Vec2 b, Vec2 point) {
    const double squared = squaredLength(b - a);
    if (squared <= 0) return a;
    return lerp(a, b, std::clamp(dot(point - a, b - a) / squared, 0.0, 1.0));
}

double distanceToBorder(std::span<const Vec2> polygon, Vec2 point) {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0, n = polygon.size(); i < n; ++i)
        best =
            std::min(best, squaredLength(point - closestOnSegment(polygon[i], polygon[i + 1 < n ? i + 1 : 0], point)));
    return std::sqrt(best);
}

Box2 boundsOf(std::span<const Vec2> points) {
    if (points.empty()) return {};
    Box2 box{points.front(), points.front()};
    for (const Vec2 p : points) {
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

} // namespace toile::geometry
