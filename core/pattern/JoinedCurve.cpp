// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/JoinedCurve.h"

#include "core/pattern/PatternContours.h"

#include <algorithm>
#include <cmath>

namespace toile::pattern {
namespace {

using geometry::ArcShape;
using geometry::CubicShape;
using geometry::Curve;
using geometry::LineShape;

constexpr double sameCircle = 1e-7; ///< arcs whose centres and radii differ by less lie on one circle [m]

struct ArcCircle {
    Vec2 centre;
    double radius = 0;
};

/// An arc of bulge ≠ 0.
ArcCircle circleOf(const Curve& curve, double bulge) {
    const Vec2 chord = curve.end - curve.start;
    const Vec2 centre =
        geometry::lerp(curve.start, curve.end, 0.5) + geometry::leftOf(chord) * ((1 - bulge * bulge) / (4 * bulge));
    return {centre, geometry::distance(centre, curve.start)};
}

/// The arc that two arcs of one circle make together.
std::optional<ArcShape> joinedArc(const Curve& a, const Curve& b) {
    const auto *first = std::get_if<ArcShape>(&a.shape), *second = std::get_if<ArcShape>(&b.shape);
    if (!first || !second || first->bulge * second->bulge <= 0) return std::nullopt;
    const ArcCircle one = circleOf(a, first->bulge), other = circleOf(b, second->bulge);
    if (geometry::distance(one.centre, other.centre) > sameCircle || std::abs(one.radius - other.radius) > sameCircle)
        return std::nullopt;
    const double quarterSweep = std::atan(first->bulge) + std::atan(second->bulge);
    constexpr double almostRound = 1.5; // a whole circle is π/2 and has no chord to bulge from
    return std::abs(quarterSweep) < almostRound ? std::optional(ArcShape{std::tan(quarterSweep)}) : std::nullopt;
}

/// The cubic that de Casteljau would have split into the two, if there is one; else one with the same end tangents.
CubicShape joinedCubic(const Curve& a, const Curve& b) {
    const CubicShape first = cubicOf(a), second = cubicOf(b);
    const double in = geometry::distance(first.control2, a.end), out = geometry::distance(b.start, second.control1);
    const double t = in + out > 0 ? in / (in + out) : jointOf(a, b);
    const double share = std::clamp(t, 0.05, 0.95); // a tiny part must not throw the handle far away
    return {a.start + (first.control1 - a.start) / share, b.end + (second.control2 - b.end) / (1 - share)};
}

} // namespace

Curve joinedCurve(const Curve& a, const Curve& b) {
    if (std::holds_alternative<LineShape>(a.shape) && std::holds_alternative<LineShape>(b.shape))
        return {a.start, b.end, LineShape{}};
    if (const auto arc = joinedArc(a, b)) return {a.start, b.end, *arc};
    return {a.start, b.end, joinedCubic(a, b)};
}

double jointOf(const Curve& a, const Curve& b) {
    const double before = geometry::length(a), after = geometry::length(b);
    return before + after > 0 ? before / (before + after) : 0.5;
}

bool sameCourse(const Curve& joined, const Curve& a, const Curve& b, double fraction) {
    constexpr double tolerance = 1e-6; // [m]
    const geometry::ArcLength whole(joined), first(a), second(b);
    for (const double f : {0.25, 0.5, 0.75, 1.0}) {
        if (geometry::distance(whole.pointAt(fraction * f), first.pointAt(f)) > tolerance) return false;
        if (geometry::distance(whole.pointAt(fraction + (1 - fraction) * f), second.pointAt(f)) > tolerance)
            return false;
    }
    return true;
}

} // namespace toile::pattern
