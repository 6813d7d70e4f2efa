// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SymplecticEuler.h"

#include <fmt/format.h>

namespace toile::dynamics {

double SymplecticEuler::stepLimit(std::span<const Vec3> positions, std::span<Stage* const> stages) const {
    return 2 / frequency_.largest(positions, stages);
}

Result<StepReport> SymplecticEuler::advance(ParticleState& state, double duration, const Vec3& gravity,
                                            std::span<Stage* const> stages, std::stop_token stop) {
    const double limit = stepLimit(state.positions, stages);
    if (duration > limit && !settings_.automaticSubsteps)
        return fail(
            ErrorCode::invalidInput,
            fmt::format("A step of {:.3g} s is beyond the limit of {:.3g} s of explicit steps.", duration, limit));
    const auto parts = explicitParts(duration, limit, settings_.safety);
    if (!parts) return tl::unexpected(parts.error());
    for (Stage* stage : stages) stage->beginStep(state, duration);
    const double h = duration / *parts;
    std::vector<Vec3> from;
    for (int part = 0; part < *parts; ++part) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "The step was stopped.");
        if (!stages.empty()) from = state.positions;
        accelerationsAt(state, h, gravity, stages, accelerations_);
        for (const int p : eliminated().free()) {
            Vec3& v = state.velocities[p];
            v += h * (accelerations_[p] - settings_.damping * v);
            state.positions[p] += h * v;
        }
        eliminated().place(state.positions);
        eliminated().place(state.velocities);
        hold(from, state, h, stages);
    }
    return StepReport{.parts = *parts, .limit = limit};
}

} // namespace toile::dynamics
