// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/EnergyWatch.h"

#include "core/cloth/Forces.h"

#include <algorithm>

namespace toile::dynamics {

EnergyWatch::EnergyWatch(const cloth::ClothModel& model, const Vec3& gravity, double allowed)
    : model_(model), gravity_(gravity), allowed_(allowed), turnover_(model, gravity) {}

bool EnergyWatch::gains(const ParticleState& before, const ParticleState& after) {
    const Energies then = energiesOfMotion(model_, before, gravity_), now = energiesOfMotion(model_, after, gravity_);
    turnover_.observe(then);
    const double rise = now.total() - then.total();
    if (rise <= allowed_ * turnover_.joules()) return false; // seldom else: what is stored need not be looked at
    const double stored = cloth::energy(model_, before.positions);
    const double released = std::max(0.0, stored - cloth::energy(model_, after.positions));
    return rise - released > allowed_ * std::max(turnover_.joules(), stored);
}

} // namespace toile::dynamics
