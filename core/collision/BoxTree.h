// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <vector>

namespace toile::collision {

/// A node of a binary hierarchy of boxes: two children side by side, or one triangle.
struct BoxNode {
    Vec3 low, high;     ///< [m]
    int firstChild = 0; ///< the second is firstChild + 1; unused in a leaf
    int triangle = -1;  ///< −1 = not a leaf
};

/// The hierarchy over all triangles, root first; one triangle per leaf. Made by FCL, whose own distance queries are
/// not used (docs/collision.md). The mesh has at least one triangle.
[[nodiscard]] std::vector<BoxNode> boxTreeOf(const geometry::TriangleMesh& mesh);

} // namespace toile::collision
