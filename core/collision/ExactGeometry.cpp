// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/ExactGeometry.h"

#include <algorithm>
#include <utility>

namespace toile::collision::exact {
namespace {

__extension__ using Wide = __int128;
using WideVector = std::array<Wide, 3>; // 2·41 + 1 bits are used

Point difference(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

WideVector crossOf(const Point& a, const Point& b) {
    const auto minor = [&](int i, int j) { return Wide(a[i]) * b[j] - Wide(a[j]) * b[i]; };
    return {minor(1, 2), minor(2, 0), minor(0, 1)};
}

int signOf(Wide x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

/// Sign of the volume of (a, b, c, d): on which side of the plane abc d lies.
int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    const WideVector n = crossOf(difference(b, a), difference(c, a));
    const Point e = difference(d, a);
    return signOf(n[0] * e[0] + n[1] * e[1] + n[2] * e[2]); // below 3·2⁸³·2⁴¹
}

/// An axis along which the vector is not zero; −1 for the zero vector.
int axisOf(const WideVector& v) {
    for (int axis = 0; axis < 3; ++axis)
        if (v[axis] != 0) return axis;
    return -1;
}

/// Turning direction of a, b, c seen along an axis.
int turn(const Point& a, const Point& b, const Point& c, int axis) {
    return signOf(crossOf(difference(b, a), difference(c, a))[axis]);
}

bool between(std::int64_t a, std::int64_t b, std::int64_t x) {
    return std::min(a, b) <= x && x <= std::max(a, b);
}

bool inBoxOf(const Point& p, const Point& q, const Point& x) {
    return between(p[0], q[0], x[0]) && between(p[1], q[1], x[1]) && between(p[2], q[2], x[2]);
}

bool onSegment(const Point& p, const Point& q, const Point& x) {
    return axisOf(crossOf(difference(q, p), difference(x, p))) < 0 && inBoxOf(p, q, x);
}

bool segmentsMeet(const Point& p, const Point& q, const Point& a, const Point& b) {
    if (onSegment(p, q, a) || onSegment(p, q, b) || onSegment(a, b, p) || onSegment(a, b, q)) return true;
    if (orientation(p, q, a, b) != 0) return false;
    const int axis = axisOf(crossOf(difference(q, p), difference(b, a)));
    if (axis < 0) return false; // parallel, and no end lies on the other
    return turn(p, q, a, axis) * turn(p, q, b, axis) < 0 && turn(a, b, p, axis) * turn(a, b, q, axis) < 0;
}

bool meetsAnEdge(const Point& p, const Point& q, const Triangle& t) {
    return segmentsMeet(p, q, t[0], t[1]) || segmentsMeet(p, q, t[1], t[2]) || segmentsMeet(p, q, t[2], t[0]);
}

bool coversInPlane(const Triangle& t, const Point& x, int axis) {
    const int s0 = turn(t[0], t[1], x, axis), s1 = turn(t[1], t[2], x, axis), s2 = turn(t[2], t[0], x, axis);
    return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

} // namespace

bool segmentMeetsTriangle(const Point& p, const Point& q, const Triangle& t) {
    const int axis = axisOf(crossOf(difference(t[1], t[0]), difference(t[2], t[0])));
    if (axis < 0) return meetsAnEdge(p, q, t);
    const int sideP = orientation(t[0], t[1], t[2], p), sideQ = orientation(t[0], t[1], t[2], q);
    if (sideP * sideQ > 0) return false;
    if (sideP == 0 && sideQ == 0) return coversInPlane(t, p, axis) || meetsAnEdge(p, q, t);

    // the line crosses the plane in one point: is it to the same side of all edges?
    const int s0 = orientation(p, q, t[0], t[1]), s1 = orientation(p, q, t[1], t[2]),
              s2 = orientation(p, q, t[2], t[0]);
    return (s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0);
}

bool trianglesMeet(const Triangle& a, const Triangle& b) {
    for (int i = 0; i < 3; ++i)
        if (segmentMeetsTriangle(a[i], a[(i + 1) % 3], b) || segmentMeetsTriangle(b[i], b[(i + 1) % 3], a)) return true;
    return false;
}

} // namespace toile::collision::exact
