// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/GarmentAccuracy.h"

#include "core/base/Contracts.h"
#include "core/cloth/Forces.h"
#include "core/study/Calibration.h"
#include "core/study/EachPiece.h"
#include "core/study/Regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace toile::study {
namespace {

using dynamics::Method;
using simulation::Scene;

/// Student's t for 19 of 20 on both sides, of 1 to 15 degrees of freedom.
constexpr std::array studentT{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306,
                              2.262,  2.228, 2.201, 2.179, 2.160, 2.145, 2.131};

Scene sceneOf(const Scene& scene, const GarmentSetup& setup) {
    Scene changed = scene;
    changed.pattern =
        setup.regions ? coarser(scene.pattern, setup.factor) : uniformCoarser(scene.pattern, setup.factor);
    return changed;
}

/// Seams that close by so much slower.
Scene perturbed(Scene scene, int run) {
    constexpr double step = 0.002;
    scene.settings.seamTime *= 1 + step * (run / 2 + 1) * (run % 2 == 0 ? 1 : -1);
    return scene;
}

/// A run's own stop: the caller's, or the end of its budget.
class Budget {
public:
    Budget(double seconds, std::stop_token outer)
        : seconds_(seconds), forward_(outer, [this] { source_.request_stop(); }) {}
    [[nodiscard]] std::stop_token token() const { return source_.get_token(); }
    [[nodiscard]] bool isSpent() const { return spent_; }
    [[nodiscard]] double used() const { return threadSeconds() - start_; }
    /// Looks at the clock whenever the run says how far it is.
    [[nodiscard]] Progress watch() {
        return [this](double, const std::string&) {
            if (used() < seconds_) return;
            spent_ = true;
            source_.request_stop();
        };
    }

private:
    double seconds_, start_ = threadSeconds();
    bool spent_ = false;
    std::stop_source source_;
    std::stop_callback<std::function<void()>> forward_;
};

/// A drape as it came to rest, where there was motion, and after statics.
struct Draped {
    std::optional<GarmentRun> atRest;
    GarmentRun finished;
    double restSeconds = 0, finishedSeconds = 0; ///< CPU time
};

std::string statusOf(const simulation::SewReport& report, bool finished) {
    if (!report.allClosed()) return "seams are open";
    if (!report.contact.outsideBody) return "cloth is in the body";
    if (report.ending != "at rest") return "not at rest: " + report.ending;
    return finished && !report.atRest ? "no equilibrium found" : "";
}

GarmentRun lookedAt(const simulation::Simulation& simulation, simulation::SewReport report, const GarmentSetup& setup,
                    bool finished) {
    GarmentRun run{.setup = setup, .finished = finished};
    run.status = statusOf(report, finished);
    run.quantities = quantitiesOf(simulation);
    run.largestFrequency =
        std::sqrt(cloth::largestFrequencySquared(simulation.garment().model, simulation.state().positions));
    run.report = std::move(report);
    return run;
}

/// From the pattern to the drape. The look that sew() takes at its result is part of the time, what is measured here is
/// not.
Result<Draped> draped(const Scene& scene, const GarmentSetup& setup, Budget& budget) {
    const Progress watch = budget.watch();
    auto simulation = simulation::Simulation::create(sceneOf(scene, setup));
    if (!simulation) return tl::unexpected(simulation.error());
    simulation->drapeWith(setup.method);
    auto report = simulation::sew(*simulation, {.hold = 0, .finish = false}, budget.token(), watch);
    if (!report) return tl::unexpected(report.error());
    Draped result{.restSeconds = budget.used()};
    if (setup.method) result.atRest = lookedAt(*simulation, std::move(*report), setup, false);

    const double start = budget.used();
    report = simulation::sew(*simulation, {.hold = 0}, budget.token(), watch);
    if (!report) return tl::unexpected(report.error());
    result.finishedSeconds = result.restSeconds + budget.used() - start;
    result.finished = lookedAt(*simulation, std::move(*report), setup, true);
    return result;
}

std::string nameOf(const GarmentSetup& setup) {
    return fmt::format("{} × {:g}, {}", setup.regions ? "as drawn" : "uniform", setup.factor,
                       setup.method ? dynamics::nameOf(*setup.method) : "static");
}

double mainSpacing(const pattern::Pattern& pattern) {
    double largest = 0;
    for (const auto& piece : pattern.pieces) largest = std::max(largest, piece->spacing);
    return largest;
}

/// What becomes of one setup over the repetitions.
struct Attempts {
    std::optional<Draped> first;
    std::vector<double> restSeconds, finishedSeconds;
    std::string failure;
};

bool isTimedOnce(const Attempts& attempts, const GarmentPlan& plan) {
    return !attempts.failure.empty() || (attempts.first && attempts.first->finishedSeconds > plan.longRun);
}

/// Whether the same method was given up on a mesh that is no finer.
bool isHopeless(const std::vector<GarmentSetup>& setups, const std::vector<Attempts>& attempts, std::size_t which) {
    for (std::size_t i = 0; i < which; ++i)
        if (setups[i].method == setups[which].method && setups[i].factor >= setups[which].factor &&
            !attempts[i].failure.empty())
            return true;
    return false;
}

Result<void> attempt(Attempts& attempts, const Scene& scene, const GarmentSetup& setup, const GarmentPlan& plan,
                     std::stop_token stop) {
    Budget budget(plan.budget, stop);
    auto drape = draped(scene, setup, budget);
    if (!drape && budget.isSpent()) {
        attempts.failure = fmt::format("it was given up after {:g} s of CPU time", plan.budget);
        return {};
    }
    if (!drape) return tl::unexpected(drape.error());
    attempts.restSeconds.push_back(drape->restSeconds);
    attempts.finishedSeconds.push_back(drape->finishedSeconds);
    if (!attempts.first) attempts.first = std::move(*drape); // later ones are the same bits again
    return {};
}

Result<std::vector<Attempts>> allAttempts(const Scene& scene, const GarmentPlan& plan, std::stop_token stop,
                                          const std::function<void(const std::string&)>& begin) {
    std::vector<Attempts> attempts(plan.setups.size());
    const auto run = [&](std::size_t i, int) -> Result<void> {
        begin(nameOf(plan.setups[i]));
        if (isTimedOnce(attempts[i], plan)) return {};
        if (isHopeless(plan.setups, attempts, i)) {
            attempts[i].failure = "it was given up on a coarser mesh already";
            return {};
        }
        return attempt(attempts[i], scene, plan.setups[i], plan, stop);
    };
    if (auto done = inTurns(plan.setups.size(), plan.repetitions, run); !done) return tl::unexpected(done.error());
    return attempts;
}

Result<GarmentReference> reference(const Scene& scene, const GarmentPlan& plan, std::stop_token stop,
                                   const std::function<void(const std::string&)>& begin) {
    const GarmentSetup setup{.regions = false, .factor = plan.referenceFactor};
    std::vector<std::vector<Quantity>> runs;
    int particles = 0;
    for (int i = 0; i < plan.referenceRuns; ++i) {
        begin(fmt::format("reference {} of {}", i + 1, plan.referenceRuns));
        Budget unlimited(std::numeric_limits<double>::infinity(), stop);
        auto drape = draped(perturbed(scene, i), setup, unlimited);
        if (!drape) return tl::unexpected(drape.error());
        if (!drape->finished.status.empty())
            return fail(ErrorCode::notConverged,
                        fmt::format("The reference cannot be relied on: {}.", drape->finished.status));
        runs.push_back(std::move(drape->finished.quantities));
        particles = drape->finished.report.particles;
    }
    GarmentReference found = referenceOf(runs);
    found.spacing = plan.referenceFactor * mainSpacing(scene.pattern);
    found.particles = particles;
    return found;
}

struct Scatter {
    double mean = 0, deviation = 0; ///< of a single value
};

Scatter scatterOf(const std::vector<double>& values) {
    const double n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    double squares = 0;
    for (const double value : values) squares += (value - mean) * (value - mean);
    return {mean, std::sqrt(squares / (n - 1))};
}

} // namespace

GarmentPlan garmentPlan(const pattern::Pattern& pattern, bool quick) {
    GarmentPlan plan;
    if (!quick) {
        plan.referenceFactor = 0.5;
        plan.referenceRuns = 16;
        plan.repetitions = 3;
        plan.longRun = 300;
        plan.budget = 3600;
    }
    const std::vector<bool> layouts = finestSpacing(pattern) ? std::vector{true, false} : std::vector{true};
    for (const double factor : quick ? std::array{1.4, 1.2, 1.0} : std::array{1.4, 1.0, 0.7})
        for (const bool regions : layouts) {
            plan.setups.push_back({regions, factor, Method::xpbd});
            plan.setups.push_back({regions, factor, std::nullopt});
            if (!quick || (regions && factor == 1.4)) plan.setups.push_back({regions, factor, Method::trBdf2});
        }
    return plan;
}

GarmentReference referenceOf(const std::vector<std::vector<Quantity>>& runs) {
    expects(runs.size() >= 2 && runs.size() <= studentT.size() + 1, "2 to 16 reference runs");
    const double n = static_cast<double>(runs.size());
    GarmentReference reference{.runs = static_cast<int>(runs.size()), .mean = runs.front()};
    for (std::size_t q = 0; q < reference.mean.size(); ++q) {
        std::vector<double> values;
        for (const auto& run : runs)
            if (run[q].value) values.push_back(*run[q].value);
            else reference.mean[q].whyAbsent = run[q].whyAbsent;
        const double resolution = resolutionOf(reference.mean[q].measure);
        if (values.size() < runs.size()) {
            reference.mean[q].value.reset();
            reference.floor.push_back(resolution);
            continue;
        }
        const Scatter scatter = scatterOf(values);
        reference.mean[q].value = scatter.mean;
        reference.floor.push_back(
            std::max(resolution, studentT[runs.size() - 2] * scatter.deviation * std::sqrt(1 + 1 / n)));
    }
    // Each against the mean of the others, which lies farther from it than the mean of all.
    for (const auto& quantities : runs) {
        GarmentRun run{.quantities = quantities};
        judge(run, reference);
        reference.band = std::max(reference.band, run.score * n / (n - 1));
    }
    return reference;
}

void judge(GarmentRun& run, const GarmentReference& reference) {
    double squares = 0;
    int count = 0;
    run.lengthError = 0;
    run.errors.clear();
    for (std::size_t q = 0; q < reference.mean.size(); ++q) {
        const auto &expected = reference.mean[q].value, &found = run.quantities[q].value;
        run.errors.push_back(expected && found ? std::optional(*found - *expected) : std::nullopt);
        if (expected && !found && run.status.empty()) run.status = fmt::format("no {}", reference.mean[q].name);
        if (!run.errors.back()) continue;
        const double error = std::abs(*run.errors.back());
        squares += error * error / (reference.floor[q] * reference.floor[q]);
        ++count;
        if (reference.mean[q].measure == Measure::length)
            run.lengthError = std::max({run.lengthError, error, reference.floor[q]});
    }
    run.score = count > 0 ? std::sqrt(squares / count) : 0;
}

Result<GarmentAccuracy> studyGarment(const std::string& name, const Scene& scene, const GarmentPlan& plan,
                                     std::stop_token stop, const Progress& progress) {
    const double all = static_cast<double>(plan.setups.size()) * plan.repetitions + plan.referenceRuns;
    const auto begin = [&, done = 0](const std::string& what) mutable { report(progress, done++ / all, what); };
    GarmentAccuracy study{.name = name, .mainSpacing = mainSpacing(scene.pattern)};
    const std::function<void(const std::string&)> counted = begin;
    auto found = reference(scene, plan, stop, counted);
    if (!found) return tl::unexpected(found.error());
    study.reference = std::move(*found);
    auto attempts = allAttempts(scene, plan, stop, counted);
    if (!attempts) return tl::unexpected(attempts.error());
    for (std::size_t i = 0; i < plan.setups.size(); ++i) {
        Attempts& of = (*attempts)[i];
        if (!of.first) {
            study.notRun.push_back({plan.setups[i], of.failure});
            continue;
        }
        const auto append = [&](GarmentRun& run, const std::vector<double>& seconds) {
            run.spacing = plan.setups[i].factor * study.mainSpacing;
            run.time = runTimeOf(seconds);
            run.repetitions = static_cast<int>(seconds.size());
            judge(run, study.reference);
            study.runs.push_back(std::move(run));
        };
        if (of.first->atRest) append(*of.first->atRest, of.restSeconds);
        append(of.first->finished, of.finishedSeconds);
    }
    return study;
}

} // namespace toile::study
