// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Simulation.h"

#include <algorithm>

/// Cloth that nothing drives: it gains no energy, and once it is still it sleeps.
namespace toile::simulation {
namespace {

constexpr double beforeSleep = 1; ///< [s]

} // namespace

void Simulation::planEnergyWatch() {
    energyWatch_.reset();
    totalEnergyWatch_.reset();
    const auto leaveOut = [&](const char* why) { plan_.leaveOut("energy watch", why); };
    if (phase_ == Phase::sewing || !closingSeams().empty() || closingTacks() > 0) return leaveOut("seams do work");
    if (!drapingMethod_) return leaveOut("nothing moves");
    if (!grips_->empty()) return leaveOut("hands do work");
    if (motion_) return leaveOut("the body does work");
    if (std::ranges::any_of(plan_.stages(), [](const auto* stage) { return stage->isFromOutside(); }))
        return leaveOut("the air does work");
    if (!scene_.paper && drapingMethod_ == dynamics::Method::trBdf2)
        return leaveOut("its parts are as short as their error asks for");
    const bool byPositions = !scene_.paper && drapingMethod_ == dynamics::Method::xpbd;
    if (byPositions) energyWatch_ = std::make_unique<dynamics::EnergyWatch>(garment_->model, gravity());
    else totalEnergyWatch_ = std::make_unique<dynamics::TotalEnergyWatch>(garment_->model, gravity());
}

/// A step that gained energy is made again in twice as many substeps and without coarse levels, and once more in twice
/// as many; then it is taken as it is.
Result<dynamics::StepReport> Simulation::moveByPositions(double duration, std::stop_token stop) {
    constexpr int finest = 4; // times the substeps
    const dynamics::ParticleState before = energyWatch_ ? state_ : dynamics::ParticleState{};
    dynamics::StepReport report{.parts = substeps_};
    const auto move = [&] { return xpbd_->step(state_, duration, report.parts, gravity(), plan_.stages(), stop); };
    auto done = move();
    report.accurate = !done || !energyWatch_ || !energyWatch_->gains(before, state_);
    if (!report.accurate) {
        dynamics::CoarseLevels* const levels = xpbd_->correctBy(nullptr);
        while (done && !report.accurate && report.parts < finest * substeps_) {
            state_ = before;
            report.repeated += report.parts;
            report.parts *= 2;
            done = move();
            report.accurate = !energyWatch_->gains(before, state_);
        }
        xpbd_->correctBy(levels);
    }
    if (!done) return tl::unexpected(done.error());
    return report;
}

/// A step that gained energy is made again by a method that damps what it cannot resolve, whole, in two parts and in
/// four; then it is taken as it is.
Result<dynamics::StepReport> Simulation::moveByForces(double duration, std::stop_token stop) {
    constexpr int finest = 4; // parts
    const auto gains = [&] { return totalEnergyWatch_ && totalEnergyWatch_->gains(state_); };
    const dynamics::ParticleState before = state_;
    if (totalEnergyWatch_) totalEnergyWatch_->begin(before, duration, plan_.stages());
    auto done = integrator_->step(state_, duration, gravity(), plan_.stages(), stop);
    if (!done || !gains()) return done;
    ++runOfStep().redoneSteps;
    for (int parts = 1; parts <= finest; parts *= 2) {
        const int repeated = done->parts + done->repeated;
        state_ = before;
        done = moveSafely(duration, parts, stop);
        if (!done) return done;
        done->repeated += repeated;
        if (!gains()) return done;
    }
    done->accurate = false;
    return done;
}

Result<dynamics::StepReport> Simulation::moveSafely(double duration, int parts, std::stop_token stop) {
    if (!safe_) safe_ = integratorOf(dynamics::Method::backwardEuler);
    dynamics::StepReport sum{.parts = 0};
    for (int part = 0; part < parts; ++part) {
        const auto done = safe_->step(state_, duration / parts, gravity(), plan_.stages(), stop);
        if (!done) return done;
        sum += *done;
    }
    return sum;
}

/// What determines its steps is as it was, so it would go on lying there.
bool Simulation::isAsleep() const {
    return stillTime_ >= beforeSleep;
}

void Simulation::sleepFor(double duration) {
    state_.time += duration;
    sleptTime_ += duration;
    restingTime_ += duration;
    largestSpeed_ = 0;
    ++steps_;
    note(duration, {.parts = 0});
    goOnDressing(false);
}

} // namespace toile::simulation
