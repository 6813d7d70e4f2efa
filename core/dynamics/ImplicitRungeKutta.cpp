// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/ImplicitRungeKutta.h"

#include "core/dynamics/Energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace toile::dynamics {

const ButcherTableau& backwardEuler() {
    static const ButcherTableau tableau{.name = "backward-euler", .stages = 1, .a = {{{1}}}, .b = {1}};
    return tableau;
}

const ButcherTableau& implicitMidpoint() {
    static const ButcherTableau tableau{.name = "midpoint", .stages = 1, .a = {{{0.5}}}, .b = {1}};
    return tableau;
}

const ButcherTableau& trBdf2() {
    constexpr double w = std::numbers::sqrt2 / 4, d = 1 - std::numbers::sqrt2 / 2;
    static const ButcherTableau tableau{.name = "trbdf2",
                                        .stages = 3,
                                        .a = {{{0}, {d, d}, {w, w, d}}},
                                        .b = {w, w, d},
                                        .difference = {w - (1 - w) / 3, w - (3 * w + 1) / 3, d - d / 3},
                                        .guarded = true};
    return tableau;
}

const ButcherTableau& sdirk4() {
    static const ButcherTableau tableau{.name = "sdirk4",
                                        .stages = 5,
                                        .a = {{{1.0 / 4},
                                               {1.0 / 2, 1.0 / 4},
                                               {17.0 / 50, -1.0 / 25, 1.0 / 4},
                                               {371.0 / 1360, -137.0 / 2720, 15.0 / 544, 1.0 / 4},
                                               {25.0 / 24, -49.0 / 48, 125.0 / 16, -85.0 / 12, 1.0 / 4}}},
                                        .b = {25.0 / 24, -49.0 / 48, 125.0 / 16, -85.0 / 12, 1.0 / 4}};
    return tableau;
}

namespace {

/// start + h·Σ weights[j]·slopes[j]
std::vector<Vec3> combined(const std::vector<Vec3>& start, double h, std::span<const double> weights,
                           std::span<const std::vector<Vec3>> slopes) {
    std::vector<Vec3> sum = start;
    for (std::size_t j = 0; j < slopes.size(); ++j)
        if (weights[j] != 0)
            for (std::size_t p = 0; p < sum.size(); ++p) sum[p] += (h * weights[j]) * slopes[j][p];
    return sum;
}

/// Of the stages that put energy in [N].
std::vector<Vec3> forcesFromOutside(const ParticleState& state, double h, std::span<Stage* const> stages) {
    std::vector<Vec3> forces;
    for (Stage* stage : stages) {
        if (!stage->isFromOutside()) continue;
        forces.resize(state.positions.size());
        stage->take({.velocities = state.velocities, .span = h});
        stage->fixFriction(state.positions);
        stage->addForces(state.positions, forces);
    }
    return forces;
}

/// What they put in at most, by their forces at the start and at the end of a step [J].
double workBetween(const ParticleState& start, const std::vector<Vec3>& first, const ParticleState& end,
                   const std::vector<Vec3>& last) {
    double work = 0;
    for (std::size_t p = 0; p < first.size(); ++p) {
        const Vec3 way = end.positions[p] - start.positions[p];
        work += std::max({0.0, dot(first[p], way), dot(last[p], way)});
    }
    return work;
}

} // namespace

ImplicitRungeKutta::ImplicitRungeKutta(const cloth::ClothModel& model, const ButcherTableau& tableau,
                                       ImplicitSettings settings)
    : Integrator(model), tableau_(tableau), settings_(settings), stage_(model, settings) {}

Result<ImplicitRungeKutta::Step> ImplicitRungeKutta::once(const ButcherTableau& tableau, ParticleState& state, double h,
                                                          const Vec3& gravity, std::span<Stage* const> stages,
                                                          std::stop_token stop) {
    Step step;
    const ParticleState start = state;
    std::vector<std::vector<Vec3>> velocities, accelerations; // slopes of the stages so far
    for (Stage* stage : stages) stage->beginStep(start, h);
    EnergyMonitor monitor;
    std::vector<Vec3> outside;
    if (tableau.guarded) {
        outside = forcesFromOutside(start, h, stages);
        for (Stage* stage : stages) stage->fixFriction(start.positions);
        monitor.observe(energies(model(), start, gravity, stages));
    }
    for (int i = 0; i < tableau.stages; ++i) {
        const auto& row = tableau.a[i];
        if (row[i] == 0) {
            accelerations.emplace_back();
            accelerationsAt(state, h, gravity, stages, accelerations.back());
            for (std::size_t p = 0; p < state.positions.size(); ++p)
                accelerations.back()[p] -= settings_.damping * state.velocities[p];
            velocities.push_back(state.velocities);
            continue;
        }
        const ImplicitStage::Known known{combined(start.positions, h, row, velocities),
                                         combined(start.velocities, h, row, accelerations), h * row[i]};
        if (auto solved = stage_.solve(state, known, gravity, stages, stop, step.report); !solved)
            return tl::unexpected(solved.error());
        velocities.push_back(state.velocities);
        accelerations.emplace_back(state.positions.size());
        for (std::size_t p = 0; p < state.positions.size(); ++p)
            accelerations.back()[p] = (state.velocities[p] - known.velocity[p]) / known.span;
    }
    const bool lastStageIsResult = tableau.b == tableau.a[tableau.stages - 1];
    const std::vector<Vec3> lastStage = lastStageIsResult ? std::vector<Vec3>() : state.positions;
    if (!lastStageIsResult) {
        state.positions = combined(start.positions, h, tableau.b, velocities);
        state.velocities = combined(start.velocities, h, tableau.b, accelerations);
    }
    eliminated().place(state.positions);
    eliminated().place(state.velocities);
    if (!lastStageIsResult) { // Newton held the way to the last stage alone
        const auto& row = tableau.a[tableau.stages - 1];
        hold(lastStage, state, h * (1 - std::accumulate(row.begin(), row.end(), 0.0)), stages);
    }
    if (tableau.guarded) {
        const double work = workBetween(start, outside, state, forcesFromOutside(state, h, stages));
        step.gains = monitor.observe(energies(model(), state, gravity, stages), work);
    }
    if (tableau.difference != decltype(tableau.difference){})
        step.difference = combined(std::vector<Vec3>(start.positions.size()), h, tableau.difference, velocities);
    return step;
}

Result<StepReport> ImplicitRungeKutta::advance(ParticleState& state, double duration, const Vec3& gravity,
                                               std::span<Stage* const> stages, std::stop_token stop) {
    return halvedUntilSolved(state, duration, settings_.halvings,
                             [&](ParticleState& at, double h) -> Result<StepReport> {
                                 const ParticleState start = at;
                                 const auto step = once(tableau_, at, h, gravity, stages, stop);
                                 if (!step) return tl::unexpected(step.error());
                                 if (!step->gains) return step->report;
                                 at = start;
                                 auto safe = once(backwardEuler(), at, h, gravity, stages, stop);
                                 if (!safe) return tl::unexpected(safe.error());
                                 safe->report.repeated += 1;
                                 return safe->report;
                             });
}

} // namespace toile::dynamics
