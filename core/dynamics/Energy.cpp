// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Energy.h"

#include "core/cloth/Forces.h"

#include <algorithm>
#include <cmath>

namespace toile::dynamics {

Energies energiesOfMotion(const cloth::ClothModel& model, const ParticleState& state, const Vec3& gravity) {
    Energies e;
    for (std::size_t p = 0; p < model.mass.size(); ++p) {
        e.kinetic += 0.5 * model.mass[p] * squaredLength(state.velocities[p]);
        e.gravity -= model.mass[p] * dot(gravity, state.positions[p]);
    }
    return e;
}

Energies energies(const cloth::ClothModel& model, const ParticleState& state, const Vec3& gravity) {
    Energies e = energiesOfMotion(model, state, gravity);
    e.elastic = cloth::energy(model, state.positions);
    return e;
}

Energies energies(const cloth::ClothModel& model, const ParticleState& state, const Vec3& gravity,
                  std::span<Stage* const> stages) {
    Energies now = energies(model, state, gravity);
    for (Stage* stage : stages) {
        if (stage->isFromOutside() || stage->isDissipative()) continue;
        stage->beginIteration(state.positions);
        now.elastic += stage->energy(state.positions);
    }
    return now;
}

Vec3 momentum(const cloth::ClothModel& model, const ParticleState& state) {
    Vec3 sum;
    for (std::size_t p = 0; p < model.mass.size(); ++p) sum += model.mass[p] * state.velocities[p];
    return sum;
}

Vec3 angularMomentum(const cloth::ClothModel& model, const ParticleState& state) {
    Vec3 sum;
    for (std::size_t p = 0; p < model.mass.size(); ++p)
        sum += model.mass[p] * cross(state.positions[p], state.velocities[p]);
    return sum;
}

bool EnergyMonitor::observe(const Energies& now, double work) {
    if (!started_) {
        started_ = true;
        start_ = now.total();
        first_ = now;
    }
    work_ += work;
    scale_ = std::max({scale_, now.kinetic, now.elastic, std::abs(now.gravity - first_.gravity), std::abs(work_)});
    const double excess = now.total() - start_ - work_;
    growth_ = std::max(growth_, excess);
    return excess > allowedGrowth_ * scale_;
}

} // namespace toile::dynamics
