// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"

#include <vector>

namespace toile::collision {

/// The surface near a point, as a plane.
struct TangentPlane {
    Vec3 point, normal;
    [[nodiscard]] double distance(const Vec3& p) const { return dot(p - point, normal); } ///< signed [m]
};

/// Follows points that move in small steps beside a body, and asks the body as seldom as it can:
/// a point that was d away and has moved by s is at least d − s away, and over a very short way the tangent plane found
/// last stands for the surface. Beside a body that moves no plane stands for it.
class SurfaceTracker {
public:
    /// planeReach: how far a point may move from where its plane was found [m]. Moving by s changes the true distance
    /// and the plane's by at most s each; on a smooth body of radius R they differ by s²/2R.
    SurfaceTracker(const BodySurface& body, std::size_t points, double planeReach);

    /// What was found last time proves that point i, now at p, is farther than reach [m] from the surface. So was its
    /// straight way here, if it was proven or asked where it started.
    [[nodiscard]] bool stillFar(std::size_t i, const Vec3& p, double reach) const {
        const double slack = known_[i].distance - reach;
        return slack > 0 && squaredLength(p - known_[i].at) < slack * slack;
    }

    /// Point i is at p. The surface near it, or null when it is farther than reach [m] (0 or more).
    [[nodiscard]] const TangentPlane* near(std::size_t i, const Vec3& p, double reach) {
        if (stillFar(i, p, reach)) return nullptr;
        if (squaredLength(p - known_[i].at) <= squaredPlaneReach_)
            return planes_[i].distance(p) <= reach ? &planes_[i] : nullptr;
        return ask(i, p) <= reach ? &planes_[i] : nullptr;
    }

    /// The body has moved, no place of it by more than this [m]; no plane that was found stands for it any more.
    void bodyMoved(double farthest);
    /// Asks the body where point i is, now at p.
    SurfacePoint find(std::size_t i, const Vec3& p);

    [[nodiscard]] const BodySurface& body() const { return body_; }
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Known {
        Vec3 at;             ///< where it was when the body was asked [m]
        double distance = 0; ///< signed, there [m]; at least so much of a body that has moved since
    };

    double ask(std::size_t i, const Vec3& p) { return find(i, p).signedDistance; }

    const BodySurface& body_;
    double squaredPlaneReach_;
    std::vector<Known> known_;
    std::vector<TangentPlane> planes_;
};

} // namespace toile::collision
