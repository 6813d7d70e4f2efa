// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Arena.h"
#include "core/geometry/Polygon.h"

namespace toile::meshing {

using Polygons = std::pmr::vector<std::pmr::vector<Vec2>>;

/// Area of the common part of two sets of closed polylines, each filled by the even-odd rule [m²].
[[nodiscard]] double overlapArea(const Polygons& a, const Polygons& b, Arena& arena);

/// The point lies inside the set by the even-odd rule.
[[nodiscard]] bool covers(const Polygons& polygons, Vec2 point);

} // namespace toile::meshing
