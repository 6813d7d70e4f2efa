// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"
#include "core/geometry/VertexMotion.h"

#include <memory>

namespace toile::collision {

/// A body that moves while cloth lies on it: its surface at one time, and how each place of it came there.
class MovingSurface {
public:
    /// The motion fits the mesh (geometry::checkedMotion) and begins at this time [s]. The mesh is one that a
    /// BodySurface can be made of.
    MovingSurface(geometry::TriangleMesh mesh, std::shared_ptr<const geometry::VertexMotion> motion, double begins);

    /// As it is at this time [s] from now on; back in time, too.
    void moveTo(double time);

    [[nodiscard]] const BodySurface& surface() const { return surface_; }
    /// How far a place of the surface came by the last moveTo() [m].
    [[nodiscard]] Vec3 wayOf(const SurfacePoint& place) const;
    /// The farthest that any did [m].
    [[nodiscard]] double farthestWay() const { return farthest_; }
    /// The farthest that any place goes between two times, or a little more [m].
    [[nodiscard]] double farthestBetween(double from, double to) const {
        return motion_->farthest(from - begins_, to - begins_);
    }
    [[nodiscard]] double ends() const { return begins_ + motion_->duration(); } ///< when it stands still again [s]

private:
    std::shared_ptr<const geometry::VertexMotion> motion_;
    double begins_;
    BodySurface surface_;
    std::vector<Vec3> ways_, next_; ///< one per vertex [m]
    double farthest_ = 0;
};

} // namespace toile::collision
