// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/GuardedStep.h"

namespace toile::dynamics {
namespace {

Result<StepReport> inParts(int parts, Integrator& integrator, ParticleState& state, double duration,
                           const Vec3& gravity, std::span<Stage* const> stages, std::stop_token stop) {
    const ParticleState start = state;
    StepReport sum{.parts = 0};
    for (int part = 0; part < parts; ++part) {
        const auto done = integrator.step(state, duration / parts, gravity, stages, stop);
        if (!done) {
            state = start;
            return done;
        }
        sum += *done;
    }
    return sum;
}

} // namespace

Result<GuardedReport> guardedStep(const Guarded& by, ParticleState& state, double duration, const Vec3& gravity,
                                  std::span<Stage* const> stages, std::stop_token stop) {
    constexpr int finest = 4; // parts
    const ParticleState before = state;
    if (by.watch) by.watch->begin(before, duration, stages);
    const auto gains = [&] { return by.watch && by.watch->gains(state); };
    const auto mayBeBetter = [&](const Result<StepReport>& done) {
        return done ? gains() : done.error().code == ErrorCode::notConverged;
    };
    auto done = by.method.step(state, duration, gravity, stages, stop);
    bool isBad = mayBeBetter(done);
    const bool redone = isBad;
    int repeated = 0;
    for (int parts = 1; isBad && parts <= finest; parts *= 2) {
        repeated += done ? done->parts + done->repeated : 1;
        state = before;
        done = inParts(parts, by.safe(), state, duration, gravity, stages, stop);
        isBad = mayBeBetter(done);
    }
    if (!done) return tl::unexpected(done.error());
    done->repeated += repeated;
    done->accurate = done->accurate && !isBad;
    return GuardedReport{*done, redone};
}

} // namespace toile::dynamics
