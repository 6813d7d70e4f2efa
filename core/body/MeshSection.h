// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <optional>
#include <vector>

namespace toile::body {

struct Plane {
    Vec3 origin;
    Vec3 normal{0, 1, 0}; ///< unit length
};

/// One closed curve in which a plane cuts a mesh; the last point joins the first.
struct SectionLoop {
    Plane plane;
    std::vector<Vec3> points;
};

/// All curves in which the plane cuts the mesh. Where the mesh is open the curve is closed by a straight
/// line.
[[nodiscard]] std::vector<SectionLoop> sectionsOf(const geometry::TriangleMesh& mesh, const Plane& plane);

/// The curve that goes round a point of the plane, the shortest if several do.
[[nodiscard]] std::optional<SectionLoop> sectionRound(const geometry::TriangleMesh& mesh, const Plane& plane);

/// Length of the curve itself [m].
[[nodiscard]] double perimeter(const SectionLoop& loop);
/// Length of a tape laid round it: of its convex hull (ISO 8559-1) [m].
[[nodiscard]] double tapeGirth(const SectionLoop& loop);
/// The curve's points in the plane, measured from its origin. Seen along −normal the axes are right-handed.
[[nodiscard]] std::vector<Vec2> inPlane(const SectionLoop& loop);
/// Centroid of the area enclosed.
[[nodiscard]] Vec3 centreOf(const SectionLoop& loop);

/// Convex hull, counter-clockwise, without points on its sides.
[[nodiscard]] std::vector<Vec2> convexHull(std::vector<Vec2> points);
/// Length of a closed polygon [m].
[[nodiscard]] double perimeter(const std::vector<Vec2>& polygon);

} // namespace toile::body
