// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Statics.h"

#include <algorithm>

namespace toile::dynamics {
namespace {

bool anyTakesBack(std::span<Stage* const> stages, std::span<const Vec3> positions) {
    bool any = false;
    for (Stage* stage : stages) any |= stage->takesBackYield(positions);
    return any;
}

/// What both took, and where the second ended.
MinimiserReport joined(MinimiserReport first, MinimiserReport second) {
    second.iterations += first.iterations;
    second.factorizations += first.factorizations;
    second.analyses += first.analyses;
    second.gradientIterations += first.gradientIterations;
    second.log.insert(second.log.begin(), first.log.begin(), first.log.end());
    return second;
}

} // namespace

Result<StaticReport> solveStatic(const cloth::ClothModel& model, ParticleState& state, const Vec3& gravity,
                                 std::span<Stage* const> stages, const StaticSettings& settings, std::stop_token stop,
                                 const Progress& progress, Team* team) {
    const std::vector<Vec3> start = state.positions;
    for (Stage* stage : stages) stage->take({});
    const MinimiserProblem problem{.gravity = gravity, .stages = stages, .team = team};
    Minimiser minimiser(model, settings);
    auto newton = minimiser.minimise(state.positions, problem, stop, progress);
    if (newton && newton->converged && anyTakesBack(stages, state.positions)) {
        std::vector<Vec3> nearer = state.positions;
        auto again = minimiser.minimise(nearer, problem, stop, progress);
        if (!again) newton = tl::unexpected(again.error());
        else if (again->converged) {
            state.positions = std::move(nearer);
            newton = joined(std::move(*newton), std::move(*again));
        }
    }
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
