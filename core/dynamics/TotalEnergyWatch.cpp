// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/TotalEnergyWatch.h"

#include <algorithm>

namespace toile::dynamics {

TotalEnergyWatch::TotalEnergyWatch(const cloth::ClothModel& model, const Vec3& gravity, double allowed)
    : model_(model), gravity_(gravity), allowed_(allowed), turnover_(model, gravity) {}

/// What is gained is summed up step by step: what friction rests on changes between steps, and with it what stages
/// store.
void TotalEnergyWatch::begin(const ParticleState& before, double duration, std::span<Stage* const> stages) {
    for (Stage* stage : stages) {
        stage->beginStep(before, duration);
        stage->fixFriction(before.positions);
    }
    const Energies then = energies(model_, before, gravity_, stages);
    gained_ = std::clamp(gained_ + rise_, 0.0, limit_);
    rise_ = 0;
    start_ = then.total();
    turnover_.observe(then);
    limit_ = allowed_ * std::max(turnover_.joules(), then.elastic);
}

/// What stages hold at the end does not count: friction has taken its normal forces anew within the step, and so stores
/// other than it was given.
bool TotalEnergyWatch::gains(const ParticleState& after) {
    rise_ = energies(model_, after, gravity_).total() - start_;
    return !(gained_ + rise_ <= limit_);
}

} // namespace toile::dynamics
