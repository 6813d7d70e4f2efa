// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"
#include "core/geometry/VertexMotion.h"

#include <array>
#include <memory>

namespace toile::collision {

/// A place that goes along with a surface as if it were fixed to one of its triangles.
struct CarriedPlace {
    int triangle = -1;
    std::array<double, 3> shares{}; ///< of the triangle's corners in the point below it
    Vec3 offset; ///< from that point: along the first side, across it, along the normal [m]; a triangle without area
                 ///< has the axes of space instead
    friend bool operator==(const CarriedPlace&, const CarriedPlace&) = default;
};

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
    /// A point of space, as a place of the triangle that is nearest to it now.
    [[nodiscard]] CarriedPlace carried(const Vec3& point) const;
    /// Where the surface has carried it at this time [m]; the surface itself stays as it is.
    [[nodiscard]] Vec3 at(const CarriedPlace& place, double time) const;
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
