// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace toile::dynamics {

/// Σ a·b
[[nodiscard]] inline double dotOf(std::span<const Vec3> a, std::span<const Vec3> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i], b[i]);
    return sum;
}

/// Length of the longest.
[[nodiscard]] inline double largestOf(std::span<const Vec3> v) {
    double squared = 0;
    for (const Vec3& e : v) squared = std::max(squared, squaredLength(e));
    return std::sqrt(squared);
}

} // namespace toile::dynamics
