// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SymplecticEuler.h"

#include "core/base/Contracts.h"
#include "core/cloth/Forces.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::dynamics {

SymplecticEuler::SymplecticEuler(const cloth::ClothModel& model, SymplecticEulerSettings settings,
                                 std::span<const Vec3> positions)
    : model_(model), settings_(settings), held_(model.mass.size(), 0), forces_(model.mass.size()) {
    const double squared = cloth::largestFrequencySquared(model, positions);
    stepLimit_ = squared > 0 ? 2 / std::sqrt(squared) : std::numeric_limits<double>::infinity();
    for (int particle : model.pinned) held_[particle] = 1;
    for (const cloth::Slave& slave : model.slaves) held_[slave.particle] = 1;
}

Result<void> SymplecticEuler::step(ParticleState& state, double duration, const Vec3& gravity,
                                   std::span<Stage* const> stages) {
    expects(state.positions.size() == model_.mass.size(), "one position per particle");
    state.velocities.resize(state.positions.size());
    int substeps = 1;
    if (duration > stepLimit_) {
        if (!settings_.automaticSubsteps)
            return fail(ErrorCode::invalidInput,
                        fmt::format("A step of {:.3g} s is beyond the limit of {:.3g} s of explicit steps.", duration,
                                    stepLimit_));
        substeps = static_cast<int>(std::ceil(duration / (settings_.safety * stepLimit_)));
    }
    for (Stage* stage : stages) stage->beginStep(state, duration);
    for (int s = 0; s < substeps; ++s)
        if (auto done = substep(state, duration / substeps, gravity, stages); !done) return done;
    return {};
}

Result<void> SymplecticEuler::substep(ParticleState& state, double h, const Vec3& gravity,
                                      std::span<Stage* const> stages) {
    std::ranges::fill(forces_, Vec3{});
    cloth::addForces(model_, state.positions, forces_);
    for (Stage* stage : stages) {
        stage->beginIteration(state.positions);
        stage->addForces(state.positions, forces_);
    }
    cloth::gatherToMasters(model_, forces_);
    for (std::size_t p = 0; p < forces_.size(); ++p) {
        if (held_[p]) continue;
        if (!(model_.mass[p] > 0)) return fail(ErrorCode::invalidInput, fmt::format("Particle {} has no mass.", p));
        Vec3& v = state.velocities[p];
        v += h * (gravity + forces_[p] / model_.mass[p] - settings_.damping * v);
        state.positions[p] += h * v;
        if (!isFinite(state.positions[p]))
            return fail(ErrorCode::notConverged,
                        fmt::format("The position of particle {} is no number after {:.4f} s.", p, state.time + h));
    }
    cloth::placeSlaves(model_, state.positions);
    cloth::placeSlaves(model_, state.velocities);
    state.time += h;
    return {};
}

} // namespace toile::dynamics
