// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/RungeKutta4.h"

#include <numbers>

namespace toile::dynamics {

double RungeKutta4::stepLimit(std::span<const Vec3> positions, std::span<Stage* const> stages) const {
    return 2 * std::numbers::sqrt2 / frequency_.largest(positions, stages);
}

Result<StepReport> RungeKutta4::advance(ParticleState& state, double duration, const Vec3& gravity,
                                        std::span<Stage* const> stages, std::stop_token stop) {
    const double limit = stepLimit(state.positions, stages);
    const auto parts = explicitParts(duration, settings_.safety * limit, 1);
    if (!parts) return tl::unexpected(parts.error());
    for (Stage* stage : stages) stage->beginStep(state, duration);
    const double h = duration / *parts;
    constexpr double reach[4] = {0, 0.5, 0.5, 1}, weight[4] = {1.0 / 6, 1.0 / 3, 1.0 / 3, 1.0 / 6};
    const std::size_t count = state.positions.size();
    for (int part = 0; part < *parts; ++part) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "The step was stopped.");
        const ParticleState start = state;
        ParticleState at = start;
        std::vector<Vec3> velocities(count), slopes(count); // of the stage before
        for (int i = 0; i < 4; ++i) {
            for (std::size_t p = 0; p < count; ++p) {
                at.positions[p] = start.positions[p] + (h * reach[i]) * velocities[p];
                at.velocities[p] = start.velocities[p] + (h * reach[i]) * slopes[p];
            }
            eliminated().place(at.positions);
            accelerationsAt(at, h, gravity, stages, accelerations_);
            for (std::size_t p = 0; p < count; ++p) {
                velocities[p] = at.velocities[p];
                slopes[p] = accelerations_[p] - settings_.damping * at.velocities[p];
                state.positions[p] += (h * weight[i]) * velocities[p];
                state.velocities[p] += (h * weight[i]) * slopes[p];
            }
        }
        eliminated().place(state.positions);
        eliminated().place(state.velocities);
        hold(start.positions, state, h, stages);
    }
    return StepReport{.parts = *parts, .limit = limit};
}

} // namespace toile::dynamics
