// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/SurfaceTracker.h"

#include "core/base/Contracts.h"

#include <limits>

namespace toile::collision {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

} // namespace

SurfaceTracker::SurfaceTracker(const BodySurface& body, std::size_t points, double planeReach)
    : body_(body), squaredPlaneReach_(planeReach * planeReach), known_(points, Known{{unknown, 0, 0}, 0}),
      planes_(points) {}

void SurfaceTracker::bodyMoved(double farthest) {
    squaredPlaneReach_ = -1;
    for (Known& known : known_) known.distance -= farthest;
}

SurfacePoint SurfaceTracker::find(std::size_t i, const Vec3& p) {
    Known& known = known_[i];
    const double moved = distance(p, known.at); // infinite for a point that was never asked for
    const double rounding = 1e-9;               // [m]
    auto found = body_.nearest(p, std::abs(known.distance) + moved + rounding);
    const bool bodyMoves = squaredPlaneReach_ < 0;
    if (!found && bodyMoves) found = body_.nearest(p, unknown); // it has drawn away
    expects(found.has_value(), "a surface does not jump away from a point that is finite");
    known = {p, found->signedDistance};
    planes_[i] = {found->point, found->normal};
    return *found;
}

std::size_t SurfaceTracker::bytes() const {
    return known_.capacity() * sizeof(Known) + planes_.capacity() * sizeof(TangentPlane);
}

} // namespace toile::collision
