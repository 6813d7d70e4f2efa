// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Curve.h"

namespace toile::pattern {

/// What two curves make together of which the second starts where the first ends: the curve both were split from where
/// there is one, else one with the same end tangents.
[[nodiscard]] geometry::Curve joinedCurve(const geometry::Curve& a, const geometry::Curve& b);
/// Where two curves meet, as a fraction of the length of both; the middle where neither has any.
[[nodiscard]] double jointOf(const geometry::Curve& a, const geometry::Curve& b);
/// It runs where the two ran; fraction: of its length, where they met.
[[nodiscard]] bool sameCourse(const geometry::Curve& joined, const geometry::Curve& a, const geometry::Curve& b,
                              double fraction);

} // namespace toile::pattern
