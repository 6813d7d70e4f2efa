// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <memory>

namespace toile::bench {

/// A box that FCL's broad phase sees.
struct FclBox final : fcl::CollisionGeometryd {
    void fit(const geometry::Box3& box) {
        aabb_local = fcl::AABBd({box.low.x, box.low.y, box.low.z}, {box.high.x, box.high.y, box.high.z});
    }
    void around(const Vec3& p, double radius) {
        const Vec3 reach{radius, radius, radius};
        fit({p - reach, p + reach});
    }
    void computeLocalAABB() override {}
};

} // namespace toile::bench
