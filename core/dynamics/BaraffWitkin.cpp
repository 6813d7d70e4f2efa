// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BaraffWitkin.h"

namespace toile::dynamics {

Result<StepReport> BaraffWitkin::advance(ParticleState& state, double duration, const Vec3& gravity,
                                         std::span<Stage* const> stages, std::stop_token) {
    StepReport report;
    for (Stage* each : stages) each->beginStep(state, duration);
    const ImplicitStage::Known known{state.positions, state.velocities, duration};
    if (auto solved = stage_.solveLinearised(state, known, gravity, stages, report); !solved)
        return tl::unexpected(solved.error());
    hold(known.position, state, duration, stages);
    return report;
}

} // namespace toile::dynamics
