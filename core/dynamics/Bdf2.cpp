// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Bdf2.h"

namespace toile::dynamics {
namespace {

/// now + share·(now − before)
std::vector<Vec3> extended(const std::vector<Vec3>& now, const std::vector<Vec3>& before, double share) {
    std::vector<Vec3> sum = now;
    for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += share * (now[p] - before[p]);
    return sum;
}

} // namespace

std::size_t Bdf2::bytes() const {
    return ImplicitRungeKutta::bytes() + 4 * before_.positions.capacity() * sizeof(Vec3);
}

Result<StepReport> Bdf2::advance(ParticleState& state, double duration, const Vec3& gravity,
                                 std::span<Stage* const> stages, std::stop_token stop) {
    const ParticleState start = state;
    const bool goesOn = lastDuration_ > 0 && state.positions == last_.positions && state.velocities == last_.velocities;
    StepReport report;
    if (goesOn) {
        const double ratio = duration / lastDuration_, share = ratio * ratio / (1 + 2 * ratio);
        for (Stage* each : stages) each->beginStep(state, duration);
        const ImplicitStage::Known known{extended(start.positions, before_.positions, share),
                                         extended(start.velocities, before_.velocities, share),
                                         duration * (1 + ratio) / (1 + 2 * ratio)};
        if (auto solved = stage().solve(state, known, gravity, stages, stop, report); !solved)
            return tl::unexpected(solved.error());
    }
    if (!goesOn || !report.accurate) {
        state = start;
        auto parts = ImplicitRungeKutta::advance(state, duration, gravity, stages, stop);
        if (!parts) return parts;
        if (goesOn) parts->repeated += 1;
        report = *parts;
    }
    before_ = start;
    last_ = state;
    lastDuration_ = duration;
    return report;
}

} // namespace toile::dynamics
