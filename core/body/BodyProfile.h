// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/MeshSection.h"

#include <optional>
#include <vector>

namespace toile::body {

/// What horizontal sections tell of a standing body. Heights above the ground [m].
struct BodyProfile {
    double floor = 0,
           height = 0; ///< of the lowest vertex above the ground, and from there to the highest [m]
    double middle = 0; ///< x of the plane between left and right [m]
};

[[nodiscard]] BodyProfile profileOf(const geometry::TriangleMesh& mesh);

/// The outline of the trunk, neck or head at a height: the longest curve that spans the middle; none between
/// the legs.
[[nodiscard]] std::optional<SectionLoop> trunkAt(const geometry::TriangleMesh& mesh, const BodyProfile& profile,
                                                 double y);

/// The outline of the left leg at a height: the longest curve wholly on the left of the middle.
[[nodiscard]] std::optional<SectionLoop> leftLegAt(const geometry::TriangleMesh& mesh, const BodyProfile& profile,
                                                   double y);

[[nodiscard]] geometry::Box3 boundsOf(const SectionLoop& loop);
/// The point of a curve with the largest product with a direction.
[[nodiscard]] Vec3 farthest(const SectionLoop& loop, const Vec3& direction);
/// Where a horizontal curve crosses the plane x = const at its back and its front; none if it does not.
struct BackAndFront {
    Vec3 back, front;
};
[[nodiscard]] std::optional<BackAndFront> crossingsAt(const SectionLoop& loop, double x);

/// Seen in a mirror at the plane x = middle; still facing outward.
[[nodiscard]] geometry::TriangleMesh mirrored(const geometry::TriangleMesh& mesh, double middle);

} // namespace toile::body
