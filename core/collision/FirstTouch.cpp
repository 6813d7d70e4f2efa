// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/FirstTouch.h"

namespace toile::collision {

std::optional<SurfacePoint> firstTouch(const BodySurface& body, const Vec3& from, const Vec3& to, double distance) {
    constexpr double touching = 1e-5; // [m]; steps shrink with the gap, so the last of the way would take for ever
    constexpr int mostSteps = 200;    // on a grazing way; where it ends then is still outside
    const double way = length(to - from);
    std::optional<SurfacePoint> surface;
    double gone = 0;
    for (int step = 0; step < mostSteps && gone < way; ++step) {
        surface = body.nearest(from + (to - from) * (gone / way), distance + (way - gone) + touching);
        if (!surface) return std::nullopt; // what remains of the way is too short to reach it
        const double gap = surface->signedDistance - distance;
        if (step == 0 && surface->signedDistance < 0) return std::nullopt;
        if (gap <= touching) return surface;
        gone += gap;
    }
    return gone < way ? surface : std::nullopt;
}

} // namespace toile::collision
