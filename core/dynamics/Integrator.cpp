// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Integrator.h"

#include "core/base/Contracts.h"
#include "core/cloth/Forces.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::dynamics {
namespace {

constexpr double longestStep = 1; // [s]

/// A particle whose position or velocity is no number; −1 = none.
int notFinite(const ParticleState& state) {
    for (std::size_t p = 0; p < state.positions.size(); ++p)
        if (!isFinite(state.positions[p]) || !isFinite(state.velocities[p])) return static_cast<int>(p);
    return -1;
}

} // namespace

StepReport& StepReport::operator+=(const StepReport& more) {
    parts += more.parts;
    newtonIterations += more.newtonIterations;
    factorizations += more.factorizations;
    gradientIterations += more.gradientIterations;
    refusedFactor = std::max(refusedFactor, more.refusedFactor);
    repeated += more.repeated;
    accurate = accurate && more.accurate;
    residual = std::max(residual, more.residual);
    limit = std::min(limit, more.limit);
    return *this;
}

double Integrator::stepLimit(std::span<const Vec3>, std::span<Stage* const>) const {
    return std::numeric_limits<double>::infinity();
}

Result<StepReport> Integrator::step(ParticleState& state, double duration, const Vec3& gravity,
                                    std::span<Stage* const> stages, std::stop_token stop) {
    expects(state.positions.size() == model_.mass.size(), "one position per particle");
    if (!(duration > 0 && duration <= longestStep))
        return fail(
            ErrorCode::invalidInput,
            fmt::format("A step of {} s cannot be made: give one above 0 and up to {} s.", duration, longestStep));
    state.velocities.resize(state.positions.size());
    if (const int particle = notFinite(state); particle >= 0)
        return fail(
            ErrorCode::invalidInput,
            fmt::format("Particle {} has a position or velocity that is no number before the step from {:.4f} s.",
                        particle, state.time));
    if (eliminated_.massless() >= 0)
        return fail(ErrorCode::invalidInput, fmt::format("Particle {} has no mass.", eliminated_.massless()));
    if (stop.stop_requested()) return fail(ErrorCode::cancelled, "The step was stopped.");
    for (const int pinned : model_.pinned) state.velocities[pinned] = {};
    const ParticleState start = state;
    auto report = advance(state, duration, gravity, stages, stop);
    if (!report) {
        state = start;
        return report;
    }
    if (const int particle = notFinite(state); particle >= 0) {
        state = start;
        return fail(ErrorCode::notConverged,
                    fmt::format("Particle {} has a position or velocity that is no number after the step from {:.4f} s "
                                "by {}.",
                                particle, start.time, name()));
    }
    state.time = start.time + duration;
    return report;
}

void Integrator::accelerationsAt(const ParticleState& state, double h, const Vec3& gravity,
                                 std::span<Stage* const> stages, std::vector<Vec3>& accelerations) {
    const std::span<const Vec3> positions = state.positions;
    forces_.assign(positions.size(), {});
    cloth::addForces(model_, positions, forces_);
    for (Stage* stage : stages) {
        stage->take({.velocities = state.velocities, .span = h});
        stage->fixFriction(positions);
        stage->beginIteration(positions);
        stage->addForces(positions, forces_);
    }
    accelerations.assign(positions.size(), {});
    for (int p = 0; p < model_.particleCount(); ++p)
        for (const auto& [unknown, weight] : eliminated_.termsOf(p))
            accelerations[eliminated_.free()[unknown]] += weight * forces_[p];
    for (const int p : eliminated_.free()) accelerations[p] = gravity + accelerations[p] / model_.mass[p];
}

void Integrator::hold(std::span<const Vec3> from, ParticleState& state, double h,
                      std::span<Stage* const> stages) const {
    if (stages.empty()) return;
    const std::vector<Vec3> wanted = state.positions;
    for (Stage* stage : stages) stage->hold(from, state.positions);
    if (state.positions == wanted) return;
    for (std::size_t p = 0; p < wanted.size(); ++p) state.velocities[p] += (state.positions[p] - wanted[p]) / h;
    eliminated_.place(state.velocities);
}

} // namespace toile::dynamics
