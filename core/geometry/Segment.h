// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <algorithm>

namespace toile::geometry {

/// From a point to the nearest of the segment from a to b; where these are one, to that.
[[nodiscard]] inline double distanceToSegment(const Vec3& point, const Vec3& a, const Vec3& b) {
    const double along = squaredLength(b - a);
    const double part = along > 0 ? std::clamp(dot(point - a, b - a) / along, 0.0, 1.0) : 0;
    return distance(point, a + part * (b - a));
}

} // namespace toile::geometry
