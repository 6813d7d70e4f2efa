// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Sew.h"

#include "core/base/CpuTime.h"
#include "core/base/TimeLimit.h"
#include "core/base/WallTime.h"
#include "core/dynamics/Energy.h"
#include "core/simulation/HangsBy.h"
#include "core/simulation/Inspect.h"
#include "core/simulation/Warnings.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <iterator>
#include <numeric>
#include <sys/resource.h>

namespace toile::simulation {
namespace {

constexpr double restBeforeFinish = 0.5; // [s]
constexpr std::string_view timeLimitReached = "time limit reached";

/// Linux counts in kilobytes.
std::size_t peakBytes() {
    rusage usage{};
    return getrusage(RUSAGE_SELF, &usage) == 0 ? 1024 * static_cast<std::size_t>(usage.ru_maxrss) : 0;
}

std::string describe(const Simulation& simulation) {
    const auto& seams = simulation.seams();
    const auto merged = std::ranges::count(seams, true, &SeamState::merged);
    return fmt::format("{:.2f} s simulated, {} of {} seams sewn, speed {:.0f} mm/s", simulation.state().time, merged,
                       seams.size(), 1000 * simulation.largestSpeed());
}

struct Watch {
    std::stop_token stop;
    const Progress& progress;
    const FrameObserver& observer;
};

Result<void> step(Simulation& simulation, const Watch& watch, double share) {
    if (watch.stop.stop_requested()) return fail(ErrorCode::cancelled, "The run was stopped.");
    if (const auto advanced = simulation.advance(watch.stop); !advanced) return advanced;
    report(watch.progress, share, describe(simulation));
    if (watch.observer) watch.observer(simulation);
    return {};
}

Result<void> goOnFor(double seconds, Simulation& simulation, const Watch& watch) {
    const double start = simulation.state().time;
    while (simulation.state().time - start < seconds - 1e-9)
        if (const auto stepped = step(simulation, watch, 0.9); !stepped) return stepped;
    return {};
}

/// Steps until the time is over or the cloth rests.
Result<std::string> run(Simulation& simulation, const SewSettings& settings, const Watch& watch) {
    const double start = simulation.state().time, length = settings.seconds.value_or(settings.limit);
    while (true) {
        const double elapsed = simulation.state().time - start;
        if (elapsed >= length - 1e-9) return settings.seconds ? "time is up" : "limit reached";
        if (!settings.seconds && (simulation.restingTime() >= restBeforeFinish || simulation.awaitsStatics()))
            return "at rest";
        if (const auto stepped = step(simulation, watch, 0.9 * elapsed / length); !stepped)
            return tl::unexpected(stepped.error());
    }
}

/// How far from equilibrium the cloth was left. The paper has no statics.
Result<void> judgeByForce(SewReport& result, Simulation& simulation, const Watch& watch) {
    const auto seen = simulation.settle({.maximumIterations = 0}, watch.stop);
    if (!seen) return tl::unexpected(seen.error());
    result.residual = seen->newton.residual;
    result.atRest = result.ending == "at rest";
    return {};
}

/// Statics. Where it does not come to an end, a fold is still snapping through: time goes on a little, and it is tried
/// again from there.
Result<void> finish(SewReport& result, Simulation& simulation, const SewSettings& settings, const Watch& watch) {
    constexpr int attempts = 4;
    if (simulation.scene().paper) return judgeByForce(result, simulation, watch);
    result.finishDisplacementMaximum = 0;
    for (int attempt = 0; attempt < attempts && !result.atRest; ++attempt) {
        if (attempt > 0)
            if (const auto advanced = goOnFor(restBeforeFinish, simulation, watch); !advanced) return advanced;
        report(watch.progress, 0.9, "finding the equilibrium");
        const auto settled = simulation.settle(settings.statics, watch.stop, watch.progress);
        if (!settled) return tl::unexpected(settled.error());
        result.residual = settled->newton.residual;
        result.finishDisplacementMaximum = std::max(*result.finishDisplacementMaximum, settled->displacementMaximum);
        result.atRest = result.ending == "at rest" && settled->newton.converged;
        if (result.ending != "at rest") break;
    }
    return {};
}

/// Goes on after rest; what still rests then has stayed where it is.
Result<void> hold(SewReport& result, Simulation& simulation, const SewSettings& settings, const Watch& watch) {
    if (result.ending != "at rest" || settings.hold <= 0 || simulation.awaitsStatics() ||
        !hangsOnItsWaistband(simulation))
        return {};
    const double start = simulation.state().time;
    if (const auto advanced = goOnFor(settings.hold, simulation, watch); !advanced) return advanced;
    result.heldSeconds = simulation.state().time - start;
    auto ending = run(simulation, settings, watch);
    if (!ending) return tl::unexpected(ending.error());
    result.ending = std::move(*ending);
    return {};
}

void countElements(SewReport& result, const cloth::ClothModel& model) {
    result.particles = model.particleCount();
    result.springsStructural = static_cast<int>(model.structural.size());
    result.springsShear = static_cast<int>(model.shear.size());
    result.bending = static_cast<int>(model.bending.size());
    result.twist = static_cast<int>(model.twist.size());
    result.flexion = static_cast<int>(model.flexion.size());
    result.mass = std::accumulate(model.mass.begin(), model.mass.end(), 0.0);
    result.clampedCells = model.clampedCells;
}

void listTacks(SewReport& result, const Simulation& simulation) {
    for (std::size_t i = 0; i < simulation.tacks().size(); ++i) {
        const TackState& tack = simulation.tacks()[i];
        const double gap = simulation.gapOfTack(i);
        result.tacks.push_back({tack.name, tack.initialGap, gap, gap <= TackSettings{}.closedGap});
    }
}

void listFolds(SewReport& result, const Simulation& simulation) {
    const Garment& garment = simulation.garment();
    result.folds = foldReports(simulation.scene().pattern, garment.model, garment.folds, simulation.state().positions);
}

void tellOfSleep(SewReport& result) {
    if (result.sleptSeconds > 0)
        result.leftOut.push_back({"frame steps",
                                  fmt::format("of {:.1f} s: nothing had moved for a second", result.sleptSeconds),
                                  result.sleptSavedSeconds});
    if (result.sleptApartSteps > 0)
        result.leftOut.push_back({"frame steps of pieces",
                                  fmt::format("as many as {:.1f} of the garment: they had not moved for a second, "
                                              "others did",
                                              result.sleptApartSteps),
                                  result.sleptApartSavedSeconds});
}

void warnOfTimeLimit(SewReport& result) {
    result.warnings.push_back({"time limit",
                               "It was reached before the run had come to its end: what is reported is how "
                               "the cloth lay then. Allow more time, choose a larger spacing, or keep a "
                               "checkpoint and go on from it."});
}

/// All that moves the cloth.
Result<void> runAndFinish(SewReport& result, Simulation& simulation, const SewSettings& settings, const Watch& watch) {
    const auto start = std::chrono::steady_clock::now();
    auto ending = run(simulation, settings, watch);
    if (!ending) return tl::unexpected(ending.error());
    result.ending = std::move(*ending);
    if (result.ending == "at rest" && !simulation.awaitsStatics()) result.restWallSeconds = secondsSince(start);
    if (auto held = hold(result, simulation, settings, watch); !held) return held;
    if (!settings.finish || settings.seconds) return {};
    const double finishStart = processSeconds();
    if (auto finished = finish(result, simulation, settings, watch); !finished) return finished;
    if (result.finishDisplacementMaximum) result.finishSeconds = processSeconds() - finishStart;
    return {};
}

/// What only a look at the whole result can tell.
void judgeWorn(SewReport& result, const Simulation& simulation, const SewSettings& settings) {
    const Scene& scene = simulation.scene();
    if (!scene.body || (*scene.body)->axes.empty()) return;
    WornReport worn = wornReport(drapeOf(simulation), **scene.body, *simulation.body(), settings.worn);
    if (!result.allClosed()) worn.why.push_back("Not every seam is closed.");
    if (!result.allTacked()) worn.why.push_back("Not every tack is closed.");
    if (!result.atRest) worn.why.push_back("The garment is not at rest.");
    if (!result.contact.outsideBody) worn.why.push_back("The cloth is not outside the body.");
    if (!result.contact.layersApart) worn.why.push_back("Its layers have crossed, which self-contact was to prevent.");
    if (length(scene.settings.gravity) == 0) worn.why.push_back("Without gravity nothing hangs on the body.");
    worn.worn = worn.why.empty();
    result.worn = std::move(worn);
}

} // namespace

bool SewReport::allClosed() const {
    return std::ranges::all_of(seams, [](const SeamResult& seam) { return seam.state.merged; });
}

bool SewReport::allTacked() const {
    return std::ranges::all_of(tacks, &TackResult::closed);
}

bool SewReport::ranOutOfTime() const {
    return ending == timeLimitReached;
}

bool SewReport::reachedItsGoal(const SewSettings& settings) const {
    const bool apart = contact.outsideBody && contact.layersApart;
    return allClosed() && allTacked() && apart && (atRest || (settings.seconds && !ranOutOfTime()));
}

Result<SewReport> sew(Simulation& simulation, const SewSettings& settings, std::stop_token stop,
                      const Progress& progress, const FrameObserver& observer) {
    const auto wallStart = std::chrono::steady_clock::now();
    const double cpuStart = processSeconds();
    SewReport result;
    const TimeLimit limit(settings.deadline, stop);
    if (const auto done = runAndFinish(result, simulation, settings, {limit.token(), progress, observer}); !done) {
        if (!limit.ended(done.error())) return tl::unexpected(done.error());
        result.ending = timeLimitReached;
        result.atRest = false;
    }
    countElements(result, simulation.garment().model);
    result.paper = simulation.garment().paper;
    for (std::size_t seam = 0; seam < simulation.seams().size(); ++seam)
        result.seams.push_back(
            {simulation.seams()[seam], simulation.seams()[seam].merged ? SeamGap{} : simulation.gapOf(seam)});
    listTacks(result, simulation);
    listFolds(result, simulation);
    result.phases = simulation.phases();
    result.contact = contactOf(simulation);
    std::ranges::copy(simulation.garment().mesh->report.warnings, std::back_inserter(result.warnings));
    std::ranges::copy(warningsOf(simulation, result.contact), std::back_inserter(result.warnings));
    if (result.ranOutOfTime()) warnOfTimeLimit(result);
    judgeWorn(result, simulation, settings);
    result.strain = strainOf(simulation);
    result.curvature = curvatureOf(simulation);
    const dynamics::Energies energies =
        dynamics::energies(simulation.garment().model, simulation.state(), simulation.scene().settings.gravity);
    result.kineticEnergy = energies.kinetic;
    result.gravityEnergy = energies.gravity;
    result.elasticEnergy = energies.elastic;
    result.simulatedSeconds = simulation.state().time;
    result.sleptSeconds = simulation.sleptTime();
    result.sleptSavedSeconds = simulation.savedBySleep();
    result.sleptApartSteps = simulation.stepsSleptApart();
    result.sleptApartSavedSeconds = simulation.savedBySleepApart();
    result.steps = simulation.steps();
    result.substeps = simulation.substeps();
    result.peakBytes = peakBytes();
    result.refusedFactorBytes = simulation.refusedFactor();
    result.resultHash = resultHash(simulation);
    for (const StepPlan::StageCost& cost : simulation.stageCosts())
        result.stages.push_back({cost.name, cost.seconds, cost.bytes});
    result.leftOut = simulation.plan().leftOut();
    tellOfSleep(result);
    result.cpuSeconds = processSeconds() - cpuStart;
    result.wallSeconds = secondsSince(wallStart);
    return result;
}

} // namespace toile::simulation
