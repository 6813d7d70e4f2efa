// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <span>
#include <vector>

namespace toile::geometry {

/// A line in space of two points at least, no two neighbours in the same place [m].
using Polyline = std::vector<Vec3>;

[[nodiscard]] double arcLength(std::span<const Vec3> line);

/// The right-handed, orthonormal frame at an arc length from the line's first point: y along the line, z at
/// the arc length `upAt` as near to `up` as it can be, and from there carried along both ways without turning
/// about the line. Before and beyond its ends the line goes on straight. The directions change steadily along
/// each stretch, also round corners.
[[nodiscard]] Transform frameAlong(std::span<const Vec3> line, double at, const Vec3& up, double upAt = 0);

/// The arc length of the point of the line, continued straight at both ends, that is nearest to a point [m].
[[nodiscard]] double nearestArcLength(std::span<const Vec3> line, const Vec3& point);

/// The line at equal steps, its corners rounded: each point is the mean of the line round it, weighted by a
/// bell of a standard deviation of `rounding` [m]. A straight line stays one; it begins and ends where it
/// did.
[[nodiscard]] Polyline rounded(std::span<const Vec3> line, double step, double rounding);

} // namespace toile::geometry
