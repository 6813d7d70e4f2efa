// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Polygon.h"

namespace toile::meshing {

/// Area of the common part of two sets of closed polylines, each filled by the even-odd rule [m²].
[[nodiscard]] double overlapArea(const std::vector<geometry::Polygon>& a, const std::vector<geometry::Polygon>& b);

/// The point lies inside the set by the even-odd rule.
[[nodiscard]] bool covers(const std::vector<geometry::Polygon>& polygons, Vec2 point);

} // namespace toile::meshing
