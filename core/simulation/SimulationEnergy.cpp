// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/FinerSubsteps.h"
#include "core/dynamics/GuardedStep.h"
#include "core/simulation/Simulation.h"

#include <algorithm>

/// Cloth that nothing drives gains no energy.
namespace toile::simulation {

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
    if (drapingMethod_ == dynamics::Method::trBdf2) return leaveOut("its parts are as short as their error asks for");
    if (drapingMethod_ == dynamics::Method::xpbd)
        energyWatch_ = std::make_unique<dynamics::EnergyWatch>(awake().model, gravity());
    else totalEnergyWatch_ = std::make_unique<dynamics::TotalEnergyWatch>(awake().model, gravity());
}

/// A step that gained energy is made again in twice as many substeps and without coarse levels, and once more in twice
/// as many; then it is taken as it is.
Result<dynamics::StepReport> Simulation::moveByPositions(double duration, std::stop_token stop) {
    constexpr int finest = 4; // times the substeps
    const dynamics::ParticleState before = energyWatch_ ? state_ : dynamics::ParticleState{};
    auto report = moveInSubsteps(duration, substeps_, stop);
    if (!report) return report;
    report->accurate = !energyWatch_ || !energyWatch_->gains(before, state_);
    if (report->accurate) return report;
    dynamics::CoarseLevels* const levels = xpbd_->correctBy(nullptr);
    while (report && !report->accurate && report->parts < finest * substeps_) {
        const int repeated = report->repeated + report->parts;
        state_ = before;
        report = moveInSubsteps(duration, 2 * report->parts, stop);
        if (!report) break;
        report->repeated += repeated;
        report->accurate = !energyWatch_->gains(before, state_);
    }
    xpbd_->correctBy(levels);
    return report;
}

/// Counts a step that did not end in numbers until its substeps were finer.
Result<dynamics::StepReport> Simulation::moveInSubsteps(double duration, int substeps, std::stop_token stop) {
    auto report = dynamics::stepOrFiner(*xpbd_, state_, duration, substeps, gravity(), plan_.stages(), stop);
    if (report && report->repeated > 0) ++runOfStep().redoneSteps;
    return report;
}

/// The paper's steps are taken as they are: it is there to be compared with.
Result<dynamics::StepReport> Simulation::moveByForces(double duration, std::stop_token stop) {
    if (scene_.paper) return integrator_->step(state_, duration, gravity(), plan_.stages(), stop);
    const auto safe = [this]() -> dynamics::Integrator& {
        if (!safe_) safe_ = integratorOf(dynamics::Method::backwardEuler);
        return *safe_;
    };
    const auto done = dynamics::guardedStep({*integrator_, safe, totalEnergyWatch_.get()}, state_, duration, gravity(),
                                            plan_.stages(), stop);
    if (!done) return tl::unexpected(done.error());
    runOfStep().redoneSteps += done->redone;
    return done->step;
}

} // namespace toile::simulation
