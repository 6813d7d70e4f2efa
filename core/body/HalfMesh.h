// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <functional>

namespace toile::body {

/// Evens out a half mesh (x ≥ 0, open only along x = 0): vertices move toward the mean of their neighbours
/// and back onto the surface, edges flip to the Delaunay choice. Vertices with x = 0 exactly stay in that
/// plane.
void relax(geometry::TriangleMesh& half, const std::function<Vec3(const Vec3&)>& ontoSurface, int rounds);

/// The half and its mirror image as one mesh; vertices with x = 0 exactly are shared.
[[nodiscard]] geometry::TriangleMesh mirroredWhole(const geometry::TriangleMesh& half);

} // namespace toile::body
