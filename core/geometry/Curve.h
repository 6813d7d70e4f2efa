// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <bitset>
#include <utility>
#include <variant>
#include <vector>

namespace toile::geometry {

struct LineShape {
    friend constexpr bool operator==(LineShape, LineShape) = default;
};

/// Cubic Bézier; control points in the coordinates of the piece [m].
struct CubicShape {
    Vec2 control1, control2;
    friend constexpr bool operator==(const CubicShape&, const CubicShape&) = default;
};

/// Circular arc. bulge = tan(sweep / 4) [–]: 0 straight, 1 a half circle; positive turns left (counter-clockwise).
struct ArcShape {
    double bulge = 0;
    friend constexpr bool operator==(ArcShape, ArcShape) = default;
};

using EdgeShape = std::variant<LineShape, CubicShape, ArcShape>;

/// A directed curve of the plane.
struct Curve {
    Vec2 start, end;
    EdgeShape shape;
    friend bool operator==(const Curve&, const Curve&) = default;
};

/// Point at parameter t in [0, 1].
[[nodiscard]] Vec2 pointAt(const Curve& curve, double t);
/// Derivative by t (not normalised; for a degenerate end of a Bézier the limit direction).
[[nodiscard]] Vec2 tangentAt(const Curve& curve, double t);
[[nodiscard]] Curve reversed(const Curve& curve);
/// The parts before and after parameter t.
[[nodiscard]] std::pair<Curve, Curve> splitAt(const Curve& curve, double t);
/// Polyline from start to end whose distance to the curve is at most chordError [m]; includes both ends.
[[nodiscard]] std::vector<Vec2> flattened(const Curve& curve, double chordError);
/// How many equal steps of the parameter it has.
[[nodiscard]] int flatteningSteps(const Curve& curve, double chordError);
/// The curve seen in a mirror along the line through a and b, from mirrored start to mirrored end.
[[nodiscard]] Curve mirrored(const Curve& curve, Vec2 a, Vec2 b);
[[nodiscard]] Vec2 mirrored(Vec2 point, Vec2 a, Vec2 b);

/// Arc length along a curve, to a relative error of about 1e-12 (Gauss–Legendre on halved intervals).
class ArcLength {
public:
    explicit ArcLength(const Curve& curve);

    [[nodiscard]] double total() const { return lengths_[intervals_]; }
    /// Parameter t whose arc length from the start is fraction · total.
    [[nodiscard]] double parameterAt(double fraction) const;
    /// Arc length from the start up to t, divided by the total.
    [[nodiscard]] double fractionAt(double t) const;
    /// Point at that fraction of the arc length.
    [[nodiscard]] Vec2 pointAt(double fraction) const { return geometry::pointAt(curve_, parameterAt(fraction)); }

private:
    static constexpr std::size_t mostIntervals = 32;

    /// The parameter at which an interval begins.
    [[nodiscard]] double begin(std::size_t interval) const {
        return static_cast<double>(interval) / static_cast<double>(intervals_);
    }

    Curve curve_;
    std::size_t intervals_ = 1;                       ///< lines and arcs have constant speed
    std::array<double, mostIntervals + 1> lengths_{}; ///< from the start to where each interval begins
    std::bitset<mostIntervals> smooth_; ///< one formula gives the length of the interval, and so of a part of it
};

[[nodiscard]] double length(const Curve& curve);

} // namespace toile::geometry
