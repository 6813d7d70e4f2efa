// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/BodyPins.h"

#include <algorithm>

namespace toile::simulation {

std::vector<BodyPin> pinnedTo(const collision::MovingSurface& body, std::span<const int> particles,
                              std::span<const Vec3> positions) {
    std::vector<BodyPin> pins;
    for (const int particle : particles) pins.push_back({particle, body.carried(positions[particle])});
    return pins;
}

double farthestOff(const collision::MovingSurface& body, std::span<const BodyPin> pins, std::span<const Vec3> positions,
                   double time) {
    double farthest = 0;
    for (const BodyPin& pin : pins)
        farthest = std::max(farthest, geometry::distance(positions[pin.particle], body.at(pin.place, time)));
    return farthest;
}

void BodyPins::project(dynamics::Substep& substep) {
    for (const BodyPin& pin : pins_) substep.positions[pin.particle] = body_.at(pin.place, substep.time);
}

} // namespace toile::simulation
