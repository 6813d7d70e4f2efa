// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Clearing.h"

#include "core/pattern/PatternPlacement.h"

#include <algorithm>

namespace toile::simulation {

bool isClear(const std::vector<Vec2>& points, const pattern::Placement& placement, const collision::BodySurface& body) {
    constexpr double clearance = 0.006; // twice the skin offset [m]
    constexpr double depth = 0.2;       // no piece starts deeper in a body [m]
    return std::ranges::none_of(points, [&](Vec2 point) {
        const auto nearest = body.nearest(pattern::placed(placement, point), depth);
        return nearest && nearest->signedDistance < clearance;
    });
}

pattern::Placement movedClear(const std::vector<Vec2>& points, const pattern::Placement& placement,
                              const collision::BodySurface& body) {
    constexpr double step = 0.005, farthest = 0.15; // [m]
    const bool tube = isTube(points, placement);
    for (double way = 0; way <= farthest; way += step) {
        pattern::Placement moved = pattern::movedOutward(placement, way);
        if (!tube) moved.curl = placement.curl;
        if (isClear(points, moved, body)) return moved;
    }
    return placement;
}

std::optional<pattern::Placement> clearRound(const geometry::Polyline& limb, double end, const TubePlace& asked,
                                             const std::vector<Vec2>& points, const collision::BodySurface& body) {
    constexpr double slide = 0.01, farthest = 0.25, widening = 0.005, widest = 0.03; // [m]
    const Extent along = extentAlong(points, asked.axis);
    const double first = asked.at + (asked.towardsEnd ? along.high : -along.low) > end ? -slide : slide;
    for (double wider = 0; wider <= widest; wider += widening)
        for (const double step : {first, -first})
            for (double way = 0; std::abs(way) <= farthest; way += step) {
                TubePlace place = asked;
                place.at += way;
                place.radius += wider;
                const pattern::Placement placement = placedRound(limb, place, along.low, along.high);
                if (isClear(points, placement, body)) return placement;
            }
    return std::nullopt;
}

} // namespace toile::simulation
