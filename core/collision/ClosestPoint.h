// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

namespace toile::collision {

/// The part of a triangle (a, b, c) a point lies on: its inside, or one of the edges and corners that border it.
enum class TrianglePart { inside, edgeAB, edgeBC, edgeCA, cornerA, cornerB, cornerC };

struct TrianglePoint {
    Vec3 point;
    TrianglePart part = TrianglePart::inside;
};

/// Nearest point of a triangle with area, by the Voronoi regions of its parts.
/// Ref: Ericson 2005, Real-Time Collision Detection, §5.1.5.
[[nodiscard]] TrianglePoint closestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// The same for a triangle whose corners lie on a line (a sliver): the nearest point of its three edges.
[[nodiscard]] TrianglePoint closestOnSliver(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace toile::collision
