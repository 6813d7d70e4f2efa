// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/ElementPair.h"

#include "core/collision/ClosestPoint.h"

#include <algorithm>

namespace toile::collision {
namespace {

double fractionAlong(const Vec3& p, const Vec3& from, const Vec3& to) {
    const Vec3 along = to - from;
    const double squared = squaredLength(along);
    return squared > 0 ? std::clamp(dot(p - from, along) / squared, 0.0, 1.0) : 0;
}

/// Barycentric coordinates of a point that lies on a triangle.
std::array<double, 3> coordinatesOf(const TrianglePoint& at, const Vec3& a, const Vec3& b, const Vec3& c) {
    using enum TrianglePart;
    switch (at.part) {
    case cornerA: return {1, 0, 0};
    case cornerB: return {0, 1, 0};
    case cornerC: return {0, 0, 1};
    case edgeAB: {
        const double t = fractionAlong(at.point, a, b);
        return {1 - t, t, 0};
    }
    case edgeBC: {
        const double t = fractionAlong(at.point, b, c);
        return {0, 1 - t, t};
    }
    case edgeCA: {
        const double t = fractionAlong(at.point, c, a);
        return {t, 0, 1 - t};
    }
    case inside: break;
    }
    const Vec3 normal = cross(b - a, c - a);
    const double whole = squaredLength(normal);
    const double ofA = dot(cross(b - at.point, c - at.point), normal) / whole;
    const double ofB = dot(cross(c - at.point, a - at.point), normal) / whole;
    return {ofA, ofB, 1 - ofA - ofB};
}

std::array<double, 4> cornerAndTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double doubledArea = squaredLength(cross(b - a, c - a));
    const bool sliver = !(doubledArea > 1e-24 * squaredLength(b - a) * squaredLength(c - a));
    const auto [u, v, w] = coordinatesOf(sliver ? closestOnSliver(p, a, b, c) : closestOnTriangle(p, a, b, c), a, b, c);
    return {1, -u, -v, -w};
}

/// Ref: Ericson 2005, Real-Time Collision Detection, §5.1.9.
std::array<double, 4> edgeAndEdge(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
    const Vec3 first = q - p, second = s - r, between = p - r;
    const double squaredFirst = squaredLength(first), squaredSecond = squaredLength(second);
    const double mixed = dot(first, second), along = dot(first, between), across = dot(second, between);
    const double determinant = squaredFirst * squaredSecond - mixed * mixed;
    const bool parallel = !(determinant > 1e-14 * squaredFirst * squaredSecond);
    double t = parallel ? 0.5 : std::clamp((mixed * across - along * squaredSecond) / determinant, 0.0, 1.0);
    double u = squaredSecond > 0 ? (mixed * t + across) / squaredSecond : 0;
    if (u < 0 || u > 1) {
        u = std::clamp(u, 0.0, 1.0);
        t = squaredFirst > 0 ? std::clamp((mixed * u - along) / squaredFirst, 0.0, 1.0) : 0;
    }
    return {1 - t, t, u - 1, -u};
}

} // namespace

Separation separationOf(const ElementPair& pair, std::span<const Vec3> positions) {
    const auto at = [&](int i) -> const Vec3& { return positions[pair.vertices[i]]; };
    Separation found;
    found.weights =
        pair.firstCount == 1 ? cornerAndTriangle(at(0), at(1), at(2), at(3)) : edgeAndEdge(at(0), at(1), at(2), at(3));
    for (int i = 0; i < 4; ++i) found.way += found.weights[i] * at(i);
    found.distance = length(found.way);
    return found;
}

bool stayApart(const ElementPair& pair, std::span<const Vec3> from, std::span<const Vec3> to, double least) {
    constexpr int mostLooks = 500;
    constexpr double doubt = 1.01;
    const ElementPair local{{0, 1, 2, 3}, pair.firstCount};
    std::array<Vec3, 4> now, ways;
    for (int i = 0; i < 4; ++i) {
        now[i] = from[pair.vertices[i]];
        ways[i] = to[pair.vertices[i]] - now[i];
    }
    double time = 0;
    for (int look = 0; look < mostLooks; ++look) {
        const Separation found = separationOf(local, now);
        if (!(found.distance > doubt * least)) return false;
        const Vec3 direction = found.way / found.distance;
        double further = 1; // until a corner of one is nearer than `least` to one of the other along the shortest way
        for (int i = 0; i < pair.firstCount; ++i)
            for (int k = pair.firstCount; k < 4; ++k)
                if (const double nearing = dot(direction, ways[k] - ways[i]); nearing > 0)
                    further = std::min(further, (dot(direction, now[i] - now[k]) - least) / nearing);
        if (!(further > 0)) return false; // rounding: of edges as good as parallel this way is not the shortest
        time += further;
        if (!(time < 1)) return true;
        for (int i = 0; i < 4; ++i) now[i] = lerp(from[pair.vertices[i]], to[pair.vertices[i]], time);
    }
    return false;
}

bool segmentPierces(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = cross(b - a, c - a);
    const double before = dot(normal, p - a), after = dot(normal, q - a);
    if ((before > 0) == (after > 0)) return false;
    constexpr double inPlane = 1e-12; // [m]: in flat cloth the sign of what remains is rounding
    if (std::max(std::abs(before), std::abs(after)) <= inPlane * length(normal)) return false;
    const Vec3 along = q - p;
    const auto side = [&](const Vec3& from, const Vec3& to) { return dot(along, cross(from - p, to - p)); };
    const double ab = side(a, b), bc = side(b, c), ca = side(c, a);
    return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
}

} // namespace toile::collision
