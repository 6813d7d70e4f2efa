// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <vector>

namespace toile::collision {

/// The corners of a mesh at which it curves outward more sharply, in the mean of all directions, than a ball
/// of a radius [m]: finger tips, toes, nipples, also the ridge of a cylinder of half that radius. Cloth whose
/// elements are no smaller bridges them, and dips in between.
[[nodiscard]] std::vector<int> bumpsOf(const geometry::TriangleMesh& mesh, double radius);

} // namespace toile::collision
