// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Accuracy.h"

#include "core/base/Contracts.h"
#include "core/study/Repetitions.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::study {
namespace {

using dynamics::Method;

constexpr double bandFactor = 3;     ///< times the reference's own error: nothing below is told apart [–]
constexpr double explicitPart = 0.5; ///< of its limit that an explicit method takes at once [–]

int stepsBelow(double limit, double duration) {
    const int steps = static_cast<int>(std::ceil(duration / limit));
    return (steps + sampleCount - 1) / sampleCount * sampleCount;
}

/// Position-based steps are drawn at the length of a substep: frames of a twentieth of the scene are divided.
std::vector<Setup> setupsFor(const Scene& scene) {
    std::vector<Setup> setups;
    for (const int divided : {1, 4, 16, 64}) setups.push_back({Method::xpbd, sampleCount, divided});
    for (const Method method :
         {Method::trBdf2, Method::bdf2, Method::midpoint, Method::sdirk4, Method::backwardEuler, Method::baraffWitkin})
        for (int steps = sampleCount; steps <= 16 * sampleCount; steps *= 2) setups.push_back({method, steps});
    for (const Method method : {Method::symplecticEuler, Method::subcycledEuler, Method::rk4}) {
        const int steps = stepsBelow(explicitPart * stepLimitOf(scene, method), scene.duration);
        for (const int divided : {1, 2}) setups.push_back({method, steps * divided});
    }
    return setups;
}

/// Halves the steps until that changes nothing that could be seen in a plot.
Result<Reference> referenceOf(const Scene& scene, std::stop_token stop) {
    constexpr double wanted = 1e-6; // of the size of the piece [–]
    constexpr int mostHalvings = 5;
    Reference reference;
    reference.setup = {Method::rk4, stepsBelow(explicitPart * stepLimitOf(scene, Method::rk4), scene.duration)};
    auto coarse = trajectoryOf(scene, reference.setup, stop);
    for (int halving = 0; coarse && halving < mostHalvings; ++halving) {
        reference.setup.steps *= 2;
        auto fine = trajectoryOf(scene, reference.setup, stop);
        if (!fine) return tl::unexpected(fine.error());
        reference.selfError = differenceOf(scene, *fine, *coarse).maximum;
        coarse = std::move(fine);
        if (reference.selfError < wanted * scene.size) break;
    }
    if (!coarse) return tl::unexpected(coarse.error());
    reference.trajectory = std::move(*coarse);
    return reference;
}

} // namespace

double bandOf(const Reference& reference) {
    constexpr double rounding = 1e-12; // [m]
    return std::max(bandFactor * reference.selfError, rounding);
}

AccuracyPlan accuracyPlan(const std::vector<std::string>& scenes, bool quick) {
    AccuracyPlan plan{.repetitions = quick ? 3 : 5};
    for (const std::string_view name : sceneNames()) {
        if (!scenes.empty() && std::ranges::find(scenes, name) == scenes.end()) continue;
        std::vector<double> factors = name == "oscillator" ? std::vector<double>{1} : std::vector<double>{1, 100};
        if (!quick && name != "oscillator") factors.push_back(1e4);
        for (const double factor : factors) {
            const SceneSettings settings{.cells = quick ? 16 : 32, .stiffnessFactor = factor};
            const auto scene = sceneNamed(name, settings);
            plan.cases.push_back({std::string(name), settings, setupsFor(*scene)});
        }
    }
    return plan;
}

Result<CaseResult> studied(const AccuracyCase& which, int repetitions, std::stop_token stop, const Progress& progress) {
    auto scene = sceneNamed(which.scene, which.settings);
    if (!scene) return fail(ErrorCode::notFound, fmt::format("There is no scene \"{}\".", which.scene));
    CaseResult result{
        .scene = std::move(*scene), .cells = which.settings.cells, .stiffnessFactor = which.settings.stiffnessFactor};
    report(progress, 0, result.scene.name + ": reference");
    auto reference = referenceOf(result.scene, stop);
    if (!reference) return tl::unexpected(reference.error());
    result.reference = std::move(*reference);

    const std::size_t count = which.setups.size();
    std::vector<std::vector<double>> seconds(count);
    for (const Setup& setup : which.setups)
        result.runs.push_back({.setup = setup, .step = result.scene.duration / (setup.steps * setup.substeps)});
    const auto runOne = [&](std::size_t i, int repetition) -> Result<void> {
        RunResult& run = result.runs[i];
        if (repetition > 0 && !run.solved) return {}; // nothing is concluded from its time
        report(progress, double(repetition * count + i) / double(repetitions * count),
               fmt::format("{}: {}", result.scene.name, dynamics::nameOf(run.setup.method)));
        const auto trajectory = trajectoryOf(result.scene, run.setup, stop);
        if (!trajectory) {
            if (trajectory.error().code == ErrorCode::cancelled) return tl::unexpected(trajectory.error());
            run.failure = trajectory.error().text;
            run.solved = false;
            return {};
        }
        seconds[i].push_back(trajectory->seconds);
        if (repetition > 0) return {}; // the same bits again
        run.error = differenceOf(result.scene, *trajectory, result.reference.trajectory);
        run.report = trajectory->report;
        run.solved = trajectory->report.accurate;
        run.energyChange = trajectory->energyChange;
        run.inBand = run.error.maximum < bandOf(result.reference);
        return {};
    };
    if (auto done = inTurns(count, repetitions, runOne); !done) return tl::unexpected(done.error());
    for (std::size_t i = 0; i < count; ++i) {
        const RunTime time = runTimeOf(seconds[i]);
        RunResult& run = result.runs[i];
        run.secondsLeast = time.least / result.scene.duration;
        run.secondsMedian = time.median / result.scene.duration;
        run.noisy = time.noisy;
    }
    return result;
}

} // namespace toile::study
