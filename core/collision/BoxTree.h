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

/// 0 inside the box.
[[nodiscard]] inline double squaredDistance(const BoxNode& box, const Vec3& p) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double below = box.low[axis] - p[axis], above = p[axis] - box.high[axis];
        const double outside = below > 0 ? below : above > 0 ? above : 0;
        sum += outside * outside;
    }
    return sum;
}

} // namespace toile::collision
