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
    const auto leaveOut = [&](const char* why) { plan_.leaveOut("energy watch", why); };
    if (phase_ == Phase::sewing || !closingSeams().empty() || closingTacks() > 0) return leaveOut("seams do work");
    if (drapingMethod_ != dynamics::Method::xpbd) return leaveOut("no position-based steps");
    if (!grips_->empty()) return leaveOut("hands do work");
    if (motion_) return leaveOut("the body does work");
    if (std::ranges::any_of(plan_.stages(), [](const auto* stage) { return stage->isFromOutside(); }))
        return leaveOut("the air does work");
    energyWatch_ = std::make_unique<dynamics::EnergyWatch>(garment_->model, gravity());
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
