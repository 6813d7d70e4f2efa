// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace toile::cloth {

/// A triangle whose corner is nearer to the edge than this part of the edge's length has no plane: what would turn it
/// grows with 1/height and would drown all else in a sum [–].
inline constexpr double leastHeight = 1e-5;

/// The angle between two triangles (a, b, c) and (b, a, d), as Hinge has it, with its gradient at a, b, c, d.
struct FoldAngle {
    double angle = 0;               ///< [rad], in (−π, π]
    std::array<Vec3, 4> gradient{}; ///< [1/m]; 0 where a triangle has no plane
};

inline FoldAngle foldAngle(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 e = b - a, n1 = cross(e, c - a), n2 = cross(d - a, e);
    const double ee = squaredLength(e), length = std::sqrt(ee);
    const double n1n1 = squaredLength(n1), n2n2 = squaredLength(n2);
    constexpr double tiny = 1e-30;
    constexpr double flat = leastHeight * leastHeight;
    if (ee < tiny || n1n1 < flat * ee * ee || n2n2 < flat * ee * ee) return {};
    FoldAngle fold;
    fold.angle = std::atan2(dot(e, cross(n2, n1)), length * dot(n1, n2));
    const Vec3 atC = n1 * (length / n1n1), atD = n2 * (length / n2n2);
    const double s = dot(c - a, e) / ee, t = dot(d - a, e) / ee; // where the feet of c and d lie on the edge
    fold.gradient = {atC * (s - 1) + atD * (t - 1), -s * atC - t * atD, atC, atD};
    return fold;
}

/// How far an angle is from its rest [rad]: the short way round, but past a rest of more than a right angle by a right
/// angle at most, so that a flat hinge pressed to 180° knows which way it folds.
inline double angleFrom(double rest, double angle) {
    constexpr double pi = std::numbers::pi;
    const double from = angle - rest;
    if (std::abs(from) < pi) return from;
    const double over = std::copysign(std::max(0.0, std::abs(rest) - pi / 2), rest);
    return std::remainder(from + over, 2 * pi) - over;
}

} // namespace toile::cloth
