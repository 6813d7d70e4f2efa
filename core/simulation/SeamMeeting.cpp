// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SeamMeeting.h"

namespace toile::simulation {
namespace {

/// A pair that is closer has nearly met; what a body holds open is wider. Neither side moves farther than this, well
/// within the skin offset [m].
constexpr double nearlyMet = 0.002;

} // namespace

SeamMeeting::SeamMeeting(std::vector<SeamPair> pairs, SeamClosingSettings settings)
    : pairs_(std::move(pairs)), settings_(settings) {}

void SeamMeeting::project(dynamics::Substep& substep) {
    for (const SeamPair& pair : pairs_) {
        const double wa = substep.inverseMass[pair.a], wb = substep.inverseMass[pair.b];
        if (wa + wb <= 0 || SeamClosing::allowedGap(pair, substep.time, settings_) > 0) continue;
        const Vec3 apart = substep.positions[pair.b] - substep.positions[pair.a];
        if (squaredLength(apart) > nearlyMet * nearlyMet) continue;
        substep.positions[pair.a] += apart * (wa / (wa + wb));
        substep.positions[pair.b] -= apart * (wb / (wa + wb));
    }
}

} // namespace toile::simulation
