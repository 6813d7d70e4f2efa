// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Curve.h"

#include "core/base/Contracts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace toile::geometry {
namespace {

struct Circle {
    Vec2 centre;
    double startAngle = 0, sweep = 0, radius = 0;
};

constexpr double nearlyStraight = 1e-12;

bool isStraight(const Curve& curve) {
    const auto* arc = std::get_if<ArcShape>(&curve.shape);
    return std::holds_alternative<LineShape>(curve.shape) || (arc && std::abs(arc->bulge) < nearlyStraight);
}

Circle circleOf(const Curve& curve, double bulge) {
    const Vec2 chord = curve.end - curve.start;
    const Vec2 middle = lerp(curve.start, curve.end, 0.5);
    const Vec2 centre = middle + leftOf(chord) * ((1 - bulge * bulge) / (4 * bulge));
    const Vec2 arm = curve.start - centre;
    return {centre, std::atan2(arm.y, arm.x), 4 * std::atan(bulge), length(arm)};
}

Vec2 cubicAt(const Curve& c, const CubicShape& s, double t) {
    const double u = 1 - t;
    return c.start * (u * u * u) + s.control1 * (3 * u * u * t) + s.control2 * (3 * u * t * t) + c.end * (t * t * t);
}

Vec2 cubicTangent(const Curve& c, const CubicShape& s, double t) {
    const double u = 1 - t;
    const Vec2 d = (s.control1 - c.start) * (3 * u * u) + (s.control2 - s.control1) * (6 * u * t) +
                   (c.end - s.control2) * (3 * t * t);
    if (squaredLength(d) > 0) return d;
    return t < 0.5 ? s.control2 - c.start : c.end - s.control1; // a handle lies on its end point
}

/// At least one step; at most a million, however large the curve.
int wholeSteps(double steps) {
    return static_cast<int>(std::ceil(std::clamp(steps, 1.0, 1e6)));
}

/// Wang's bound: n equal parameter steps stay within the error when n² ≥ 6·max|second difference| / (8·error).
int cubicSteps(const Curve& c, const CubicShape& s, double chordError) {
    const double bend =
        std::max(length(c.start - s.control1 * 2 + s.control2), length(s.control1 - s.control2 * 2 + c.end));
    return wholeSteps(std::sqrt(0.75 * bend / chordError));
}

int arcSteps(const Circle& circle, double chordError) {
    const double half = std::acos(std::clamp(1 - chordError / circle.radius, -1.0, 1.0));
    return wholeSteps(std::abs(circle.sweep) / (2 * half));
}

/// How fast a point of the curve moves with its parameter. The derivative of a cubic is kept as a polynomial.
class Speed {
public:
    explicit Speed(const Curve& curve) : curve_(curve) {
        const auto* cubic = std::get_if<CubicShape>(&curve.shape);
        if (!cubic) return;
        const Vec2 first = cubic->control1 - curve.start, second = cubic->control2 - cubic->control1,
                   third = curve.end - cubic->control2;
        constant_ = first * 3;
        linear_ = (second - first) * 6;
        square_ = (first - second * 2 + third) * 3;
        isCubic_ = true;
    }
    double operator()(double t) const {
        if (!isCubic_) return length(tangentAt(curve_, t));
        return std::sqrt(squaredLength(constant_ + (linear_ + square_ * t) * t));
    }
    /// Five-point Gauss–Legendre.
    [[nodiscard]] double integral(double from, double to) const {
        static constexpr std::array<double, 5> node{0, 0.53846931010568309, -0.53846931010568309, 0.90617984593866399,
                                                    -0.90617984593866399};
        static constexpr std::array<double, 5> weight{0.56888888888888889, 0.47862867049936647, 0.47862867049936647,
                                                      0.23692688505618909, 0.23692688505618909};
        const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
        double sum = 0;
        for (std::size_t i = 0; i < node.size(); ++i) sum += weight[i] * (*this)(middle + half * node[i]);
        return sum * half;
    }

private:
    const Curve& curve_;
    bool isCubic_ = false;
    Vec2 constant_, linear_, square_;
};

constexpr int mostHalvings = 20;

double adaptiveLength(const Speed& speed, double from, double to, double whole, int depth) {
    const double middle = 0.5 * (from + to);
    const double left = speed.integral(from, middle), right = speed.integral(middle, to);
    if (depth == 0 || std::abs(left + right - whole) <= 1e-13 * (left + right) + 1e-18) return left + right;
    return adaptiveLength(speed, from, middle, left, depth - 1) + adaptiveLength(speed, middle, to, right, depth - 1);
}

double lengthBetween(const Speed& speed, double from, double to) {
    return adaptiveLength(speed, from, to, speed.integral(from, to), mostHalvings);
}

} // namespace

Vec2 pointAt(const Curve& curve, double t) {
    if (t <= 0) return curve.start;
    if (t >= 1) return curve.end;
    if (isStraight(curve)) return lerp(curve.start, curve.end, t);
    if (const auto* cubic = std::get_if<CubicShape>(&curve.shape)) return cubicAt(curve, *cubic, t);
    const Circle circle = circleOf(curve, std::get<ArcShape>(curve.shape).bulge);
    const double angle = circle.startAngle + t * circle.sweep;
    return circle.centre + Vec2{std::cos(angle), std::sin(angle)} * circle.radius;
}

Vec2 tangentAt(const Curve& curve, double t) {
    if (isStraight(curve)) return curve.end - curve.start;
    if (const auto* cubic = std::get_if<CubicShape>(&curve.shape)) return cubicTangent(curve, *cubic, t);
    const Circle circle = circleOf(curve, std::get<ArcShape>(curve.shape).bulge);
    const double angle = circle.startAngle + t * circle.sweep;
    return Vec2{-std::sin(angle), std::cos(angle)} * (circle.radius * circle.sweep);
}

Curve reversed(const Curve& curve) {
    Curve back{curve.end, curve.start, curve.shape};
    if (auto* cubic = std::get_if<CubicShape>(&back.shape)) std::swap(cubic->control1, cubic->control2);
    if (auto* arc = std::get_if<ArcShape>(&back.shape)) arc->bulge = -arc->bulge;
    return back;
}

std::pair<Curve, Curve> splitAt(const Curve& curve, double t) {
    const Vec2 at = pointAt(curve, t);
    Curve before{curve.start, at, curve.shape}, after{at, curve.end, curve.shape};
    if (const auto* cubic = std::get_if<CubicShape>(&curve.shape)) {
        const Vec2 a = lerp(curve.start, cubic->control1, t), b = lerp(cubic->control1, cubic->control2, t),
                   c = lerp(cubic->control2, curve.end, t);
        before.shape = CubicShape{a, lerp(a, b, t)};
        after.shape = CubicShape{lerp(b, c, t), c};
    } else if (const auto* arc = std::get_if<ArcShape>(&curve.shape)) {
        const double quarterSweep = std::atan(arc->bulge);
        before.shape = ArcShape{std::tan(quarterSweep * t)};
        after.shape = ArcShape{std::tan(quarterSweep * (1 - t))};
    }
    return {before, after};
}

int flatteningSteps(const Curve& curve, double chordError) {
    expects(chordError > 0, "a chord error is positive");
    if (const auto* cubic = std::get_if<CubicShape>(&curve.shape)) return cubicSteps(curve, *cubic, chordError);
    if (isStraight(curve)) return 1;
    return arcSteps(circleOf(curve, std::get<ArcShape>(curve.shape).bulge), chordError);
}

std::vector<Vec2> flattened(const Curve& curve, double chordError) {
    const int steps = flatteningSteps(curve, chordError);
    std::vector<Vec2> points;
    points.reserve(static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i) points.push_back(pointAt(curve, static_cast<double>(i) / steps));
    return points;
}

Vec2 mirrored(Vec2 point, Vec2 a, Vec2 b) {
    const Vec2 along = normalized(b - a);
    const Vec2 foot = a + along * dot(point - a, along);
    return foot * 2 - point;
}

Curve mirrored(const Curve& curve, Vec2 a, Vec2 b) {
    Curve image{mirrored(curve.start, a, b), mirrored(curve.end, a, b), curve.shape};
    if (auto* cubic = std::get_if<CubicShape>(&image.shape))
        *cubic = {mirrored(cubic->control1, a, b), mirrored(cubic->control2, a, b)};
    if (auto* arc = std::get_if<ArcShape>(&image.shape)) arc->bulge = -arc->bulge;
    return image;
}

ArcLength::ArcLength(const Curve& curve) : curve_(curve) {
    if (std::holds_alternative<CubicShape>(curve.shape)) intervals_ = mostIntervals;
    const Speed speed(curve_);
    for (std::size_t i = 0; i < intervals_; ++i) {
        const double whole = speed.integral(begin(i), begin(i + 1));
        lengths_[i + 1] = lengths_[i] + adaptiveLength(speed, begin(i), begin(i + 1), whole, mostHalvings);
        const double stretch = lengths_[i + 1] - lengths_[i];
        smooth_[i] = std::abs(whole - stretch) <= 1e-13 * stretch;
    }
}

double ArcLength::parameterAt(double fraction) const {
    if (fraction <= 0) return 0;
    if (fraction >= 1) return 1;
    if (intervals_ == 1 || !(total() > 0)) return fraction;
    const double wanted = fraction * total();
    const auto above = std::upper_bound(lengths_.begin(), lengths_.end(), wanted);
    const auto i = static_cast<std::size_t>(above - lengths_.begin()) - 1;
    const Speed speed(curve_);
    const double left = begin(i), right = begin(i + 1);
    const double stretch = lengths_[i + 1] - lengths_[i], part = (wanted - lengths_[i]) / stretch;
    double low = left, high = right;
    double t = low + (high - low) * part;
    const double startSpeed = speed(left), endSpeed = speed(right);
    if (startSpeed > 0 && endSpeed > 0) { // the cubic through both ends with the slopes there
        const double slopeLeft = stretch / (startSpeed * (right - left)),
                     slopeRight = stretch / (endSpeed * (right - left));
        const double rest = 1 - part;
        const double s = part * part * (3 - 2 * part) + part * rest * (slopeLeft * rest - slopeRight * part);
        if (s > 0 && s < 1) t = left + (right - left) * s;
    }
    for (int iteration = 0; iteration < 50; ++iteration) { // Newton, kept inside the bracket
        const double length = smooth_[i] ? speed.integral(left, t) : lengthBetween(speed, left, t);
        const double excess = lengths_[i] + length - wanted;
        if (std::abs(excess) <= 1e-15 * total()) break;
        (excess > 0 ? high : low) = t;
        const double here = speed(t);
        const double newton = here > 0 ? t - excess / here : low;
        t = newton > low && newton < high ? newton : 0.5 * (low + high);
        if (high - low < 1e-16 || std::abs(excess) <= 1e-9 * stretch) break; // the step squares what is left
    }
    return t;
}

double ArcLength::fractionAt(double t) const {
    if (t <= 0 || total() <= 0) return 0;
    if (t >= 1) return 1;
    if (intervals_ == 1) return t;
    const auto i = static_cast<std::size_t>(t * static_cast<double>(intervals_));
    return (lengths_[i] + lengthBetween(Speed(curve_), begin(i), t)) / total();
}

double length(const Curve& curve) {
    return ArcLength(curve).total();
}

} // namespace toile::geometry
