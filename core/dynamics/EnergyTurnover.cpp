// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/EnergyTurnover.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toile::dynamics {

EnergyTurnover::EnergyTurnover(const cloth::ClothModel& model, const Vec3& gravity) {
    constexpr double leastHeight = 1e-3; // [m]
    constexpr double leastSpeed = 1e-3;  // [m/s]
    joules_ = std::accumulate(model.mass.begin(), model.mass.end(), 0.0) *
              (length(gravity) * leastHeight + leastSpeed * leastSpeed);
}

void EnergyTurnover::observe(const Energies& now) {
    if (!firstHeight_) firstHeight_ = now.gravity;
    joules_ = std::max({joules_, now.kinetic, std::abs(now.gravity - *firstHeight_)});
}

} // namespace toile::dynamics
