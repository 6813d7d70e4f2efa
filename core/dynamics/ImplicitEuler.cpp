// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/ImplicitEuler.h"

#include "core/base/Contracts.h"

namespace toile::dynamics {

Result<MinimiserReport> ImplicitEuler::step(ParticleState& state, double duration, const Vec3& gravity,
                                            std::span<Stage* const> stages, std::stop_token stop) {
    expects(duration > 0, "a step takes time");
    state.velocities.resize(state.positions.size());
    for (Stage* stage : stages) stage->beginStep(state, duration);
    start_ = state.positions;
    target_ = start_;
    for (std::size_t p = 0; p < target_.size(); ++p) target_[p] += duration * state.velocities[p];
    auto report = minimiser_.minimise(state.positions, gravity, stages, 1 / (duration * duration), target_, stop);
    if (!report) {
        state.positions = start_;
        return report;
    }
    for (std::size_t p = 0; p < start_.size(); ++p)
        state.velocities[p] = (state.positions[p] - start_[p]) / duration;
    state.time += duration;
    return report;
}

} // namespace toile::dynamics
