// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/ImplicitStage.h"

#include <algorithm>

namespace toile::dynamics {

ImplicitStage::ImplicitStage(const cloth::ClothModel& model, const ImplicitSettings& settings)
    : model_(model), damping_(settings.damping), minimiser_(model, {.tolerance = settings.tolerance,
                                                                    .maximumIterations = settings.maximumIterations,
                                                                    .gradientIterations = settings.gradientIterations,
                                                                    .factorBytes = settings.factorBytes}) {}

double ImplicitStage::inertiaOf(double span) const {
    return (1 + damping_ * span) / (span * span);
}

std::vector<Vec3> ImplicitStage::targetOf(const Known& known) const {
    std::vector<Vec3> target = known.position;
    const double factor = known.span / (1 + damping_ * known.span);
    for (std::size_t p = 0; p < target.size(); ++p) target[p] += factor * known.velocity[p];
    return target;
}

void ImplicitStage::takeVelocities(ParticleState& state, const Known& known) const {
    for (std::size_t p = 0; p < state.positions.size(); ++p)
        state.velocities[p] = (state.positions[p] - known.position[p]) / known.span;
    for (const int pinned : model_.pinned) state.velocities[pinned] = {};
}

Result<void> ImplicitStage::solve(ParticleState& state, const Known& known, const Vec3& gravity,
                                  std::span<Stage* const> stages, std::stop_token stop, StepReport& report) {
    const std::vector<Vec3> target = targetOf(known);
    const MinimiserProblem problem{gravity, stages, inertiaOf(known.span), target};
    for (Stage* stage : stages) stage->take({.from = known.position, .span = known.span});
    if (stages.empty()) {
        std::vector<Vec3> moved = known.position;
        for (std::size_t p = 0; p < moved.size(); ++p) moved[p] += known.span * state.velocities[p];
        minimiser_.takeBetter(state.positions, moved, problem);
        minimiser_.takeBetter(state.positions, target, problem);
    }
    const auto newton = minimiser_.minimise(state.positions, problem, stop);
    if (!newton) return tl::unexpected(newton.error());
    takeVelocities(state, known);
    report.newtonIterations += newton->iterations;
    report.factorizations += newton->factorizations;
    report.gradientIterations += newton->gradientIterations;
    report.refusedFactor = std::max(report.refusedFactor, newton->refusedFactor);
    report.residual = std::max(report.residual, newton->residual);
    report.accurate = report.accurate && newton->converged;
    return {};
}

Result<void> ImplicitStage::solveLinearised(ParticleState& state, const Known& known, const Vec3& gravity,
                                            std::span<Stage* const> stages, StepReport& report) {
    const std::vector<Vec3> target = targetOf(known);
    for (Stage* stage : stages) stage->take({.velocities = known.velocity, .from = known.position, .span = known.span});
    const auto newton = minimiser_.iterateOnce(state.positions, {gravity, stages, inertiaOf(known.span), target});
    if (!newton) return tl::unexpected(newton.error());
    takeVelocities(state, known);
    report.newtonIterations += 1;
    report.factorizations += newton->factorizations;
    report.gradientIterations += newton->gradientIterations;
    report.refusedFactor = std::max(report.refusedFactor, newton->refusedFactor);
    report.accurate = report.accurate && newton->converged;
    return {};
}

std::vector<Vec3> ImplicitStage::resisted(std::span<const Vec3> change, double span) {
    return minimiser_.resisted(change, inertiaOf(span));
}

std::size_t ImplicitStage::bytes() const {
    return minimiser_.bytes();
}

} // namespace toile::dynamics
