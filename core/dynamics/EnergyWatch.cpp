// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/EnergyWatch.h"

#include "core/cloth/Forces.h"
#include "core/dynamics/Energy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace toile::dynamics {

double leastEnergy(const cloth::ClothModel& model, const Vec3& gravity) {
    constexpr double leastHeight = 1e-3; // [m]
    constexpr double leastSpeed = 1e-3;  // [m/s]
    return std::accumulate(model.mass.begin(), model.mass.end(), 0.0) *
           (length(gravity) * leastHeight + leastSpeed * leastSpeed);
}

EnergyWatch::EnergyWatch(const cloth::ClothModel& model, const Vec3& gravity, double allowed)
    : model_(model), gravity_(gravity), allowed_(allowed), scale_(leastEnergy(model, gravity)) {}

bool EnergyWatch::gains(const ParticleState& before, const ParticleState& after) {
    const Energies then = energiesOfMotion(model_, before, gravity_), now = energiesOfMotion(model_, after, gravity_);
    if (!firstHeight_) firstHeight_ = then.gravity;
    scale_ = std::max({scale_, then.kinetic, std::abs(then.gravity - *firstHeight_)});
    const double rise = now.total() - then.total();
    if (rise <= allowed_ * scale_) return false; // seldom else: what is stored need not be looked at
    const double stored = cloth::energy(model_, before.positions);
    const double released = std::max(0.0, stored - cloth::energy(model_, after.positions));
    return rise - released > allowed_ * std::max(scale_, stored);
}

} // namespace toile::dynamics
