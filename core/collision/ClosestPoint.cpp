// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/ClosestPoint.h"

#include <algorithm>
#include <array>

namespace toile::collision {
namespace {

TrianglePoint closestOnEdge(const Vec3& p, const Vec3& from, const Vec3& to, TrianglePart edge, TrianglePart first,
                            TrianglePart last) {
    const Vec3 along = to - from;
    const double squared = squaredLength(along);
    const double t = squared > 0 ? dot(p - from, along) / squared : 0;
    if (t <= 0) return {from, first};
    if (t >= 1) return {to, last};
    return {from + along * t, edge};
}

} // namespace

TrianglePoint closestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double abA = dot(ab, ap), acA = dot(ac, ap);
    if (abA <= 0 && acA <= 0) return {a, TrianglePart::cornerA};

    const Vec3 bp = p - b;
    const double abB = dot(ab, bp), acB = dot(ac, bp);
    if (abB >= 0 && acB <= abB) return {b, TrianglePart::cornerB};

    const double weightC = abA * acB - abB * acA;
    if (weightC <= 0 && abA >= 0 && abB <= 0) return {a + ab * (abA / (abA - abB)), TrianglePart::edgeAB};

    const Vec3 cp = p - c;
    const double abC = dot(ab, cp), acC = dot(ac, cp);
    if (acC >= 0 && abC <= acC) return {c, TrianglePart::cornerC};

    const double weightB = abC * acA - abA * acC;
    if (weightB <= 0 && acA >= 0 && acC <= 0) return {a + ac * (acA / (acA - acC)), TrianglePart::edgeCA};

    const double weightA = abB * acC - abC * acB;
    const double fromB = acB - abB, fromC = abC - acC;
    if (weightA <= 0 && fromB >= 0 && fromC >= 0)
        return {b + (c - b) * (fromB / (fromB + fromC)), TrianglePart::edgeBC};

    const double sum = weightA + weightB + weightC;
    return {a + ab * (weightB / sum) + ac * (weightC / sum), TrianglePart::inside};
}

TrianglePoint closestOnSliver(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    using enum TrianglePart;
    const std::array<TrianglePoint, 3> edges{closestOnEdge(p, a, b, edgeAB, cornerA, cornerB),
                                             closestOnEdge(p, b, c, edgeBC, cornerB, cornerC),
                                             closestOnEdge(p, c, a, edgeCA, cornerC, cornerA)};
    return *std::ranges::min_element(edges, {}, [&](const TrianglePoint& q) { return squaredLength(p - q.point); });
}

} // namespace toile::collision
