// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Polygon.h"

#include <span>
#include <vector>

namespace toile::pattern {

/// A connected area: the outline runs counter-clockwise, the holes clockwise.
struct Area {
    geometry::Polygon outline;
    std::vector<geometry::Polygon> holes;
};

/// What a disc of this radius covers along a stroke, as areas whose borders are within radius/50 of it [m].
[[nodiscard]] std::vector<Area> swept(std::span<const Vec2> stroke, double radius);
/// Largest first. Coordinates are rounded to 1e-8 m.
[[nodiscard]] std::vector<Area> unionOf(const std::vector<Area>& a, const std::vector<Area>& b);
[[nodiscard]] std::vector<Area> differenceOf(const std::vector<Area>& a, const std::vector<Area>& b);
[[nodiscard]] std::vector<Area> intersectionOf(const std::vector<Area>& a, const std::vector<Area>& b);

} // namespace toile::pattern
