// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace toile::collision {

/// Where a point is with respect to a surface.
struct SurfacePoint {
    double signedDistance = 0; ///< [m]; negative inside a closed surface
    Vec3 point;                ///< nearest point of the surface
    Vec3 normal;               ///< unit gradient of the signed distance: points outward
    int triangle = -1;
};

/// A body to drape on: triangles under a hierarchy of boxes. Queries may run on many threads. It stands still unless
/// it is moved (MovingSurface).
class BodySurface {
public:
    /// Error when there is no triangle or a number is not finite. An open or non-manifold mesh is accepted:
    /// see isClosed().
    [[nodiscard]] static Result<BodySurface> create(geometry::TriangleMesh mesh);

    BodySurface(BodySurface&&) noexcept;
    BodySurface& operator=(BodySurface&&) noexcept;
    ~BodySurface();

    [[nodiscard]] const geometry::TriangleMesh& mesh() const;
    [[nodiscard]] bool isClosed() const;
    /// Where it is, or was before it moved, sharper than a ball of 25 mm: cloth needs a closer look there.
    [[nodiscard]] std::vector<Vec3> bumps() const;
    [[nodiscard]] std::size_t bytes() const;

    /// Goes on with its vertices there, while nobody asks. One finite place for each vertex [m].
    void moveTo(std::span<const Vec3> vertices);

    [[nodiscard]] bool hasMoved() const;

    /// Nearest surface point within searchRadius [m] of the point; none if there is no triangle so near.
    [[nodiscard]] std::optional<SurfacePoint> nearest(const Vec3& point, double searchRadius) const;

private:
    struct Tree;
    explicit BodySurface(std::unique_ptr<Tree> tree);
    std::unique_ptr<Tree> tree_;
};

} // namespace toile::collision
