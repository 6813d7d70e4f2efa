// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Statics.h"

#include <algorithm>

namespace toile::dynamics {

Result<StaticReport> solveStatic(const cloth::ClothModel& model, ParticleState& state, const Vec3& gravity,
                                 std::span<Stage* const> stages, const StaticSettings& settings, std::stop_token stop,
                                 const Progress& progress, Team* team) {
    const std::vector<Vec3> start = state.positions;
    for (Stage* stage : stages) stage->take({});
    const MinimiserProblem problem{.gravity = gravity, .stages = stages, .team = team};
    auto newton = Minimiser(model, settings).minimise(state.positions, problem, stop, progress);
    if (!newton) {
        state.positions = start;
        return tl::unexpected(newton.error());
    }
    StaticReport report{.newton = std::move(*newton)};
    for (std::size_t p = 0; p < start.size(); ++p)
        report.displacementMaximum = std::max(report.displacementMaximum, distance(start[p], state.positions[p]));
    state.velocities.assign(state.positions.size(), Vec3{});
    return report;
}

} // namespace toile::dynamics
