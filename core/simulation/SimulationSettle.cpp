// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/AirOf.h"
#include "core/simulation/LevelsOf.h"
#include "core/simulation/SceneMemory.h"
#include "core/simulation/Simulation.h"

#include <algorithm>

/// The equilibrium of a garment.
namespace toile::simulation {
namespace {

/// Before statics of fine cloth: so many times the substeps, for so many frame steps, with so much damping [1/s].
constexpr int tautSubsteps = 4, tautFrames = 12;
constexpr double tautDamping = 10;
} // namespace

/// Cloth is as soft as its substeps are long: statics would have to draw it taut first, which many short ones do for a
/// tenth of the time where the mesh is fine; and to part layers that are jammed nearer than their thickness, which
/// takes it more iterations. The clock stands still.
Result<void> Simulation::drawTaut(std::stop_token stop) {
    const double time = state_.time, duration = scene_.settings.frameStep;
    const int substeps = fullSubsteps();
    const bool isSoft = levelPlanFor(substeps).levels > 0 || plan_.find("self-contact") != nullptr;
    if (drapingMethod_ != dynamics::Method::xpbd || scene_.paper || !isSoft) return {};
    dynamics::Xpbd xpbd(garment_->model, {.damping = tautDamping, .speedLimit = speedLimit},
                        inertiaIn(tautSubsteps * substeps));
    xpbd.workWith(teamWorthWaking());
    for (int frame = 0; frame < tautFrames; ++frame)
        if (auto done = xpbd.step(state_, duration, tautSubsteps * substeps, gravity(), plan_.stages(), stop); !done)
            return done;
    state_.time = time;
    return {};
}

Result<dynamics::StaticReport> Simulation::settle(const dynamics::StaticSettings& settings, std::stop_token stop,
                                                  const Progress& progress) {
    if (motion_) return fail(ErrorCode::invalidInput, "Beside a body that moves there is no equilibrium.");
    const dynamics::ParticleState before = state_;
    stillTime_ = 0;
    if (awake_) rebuildPlan();
    const StepPlan::OffTheClock offTheClock(plan_); // stageCosts() are of frame steps
    if (const auto taut = settings.maximumIterations > 0 ? drawTaut(stop) : Result<void>(); !taut) {
        state_ = before;
        return tl::unexpected(taut.error());
    }
    dynamics::StaticSettings within = settings;
    if (!within.factorBytes) within.factorBytes = factorBytesOf(scene_, *garment_->mesh);
    auto report = dynamics::solveStatic(garment_->model, state_, scene_.settings.gravity, plan_.stages(), within, stop,
                                        progress, teamWorthWaking());
    if (!report) {
        state_ = before;
        return report;
    }
    refusedFactor_ = std::max(refusedFactor_, report->newton.refusedFactor);
    report->displacementMaximum = 0;
    for (std::size_t p = 0; p < state_.positions.size(); ++p)
        report->displacementMaximum =
            std::max(report->displacementMaximum, geometry::distance(before.positions[p], state_.positions[p]));
    return report;
}

} // namespace toile::simulation
