// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/GarmentAccuracy.h"

#include "core/base/Contracts.h"
#include "core/study/Layouts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numeric>

namespace toile::study {
namespace {

using dynamics::Method;

/// Student's t for 19 of 20 on both sides, of 1 to 15 degrees of freedom.
constexpr std::array studentT{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306,
                              2.262,  2.228, 2.201, 2.179, 2.160, 2.145, 2.131};

/// Of the time that seams take, so much more or less.
double seamTimeOf(int referenceRun) {
    constexpr double step = 0.002;
    return 1 + step * (referenceRun / 2 + 1) * (referenceRun % 2 == 0 ? 1 : -1);
}

std::string nameOf(const GarmentSetup& setup) {
    return fmt::format("{} × {:g}, {}", layoutOf(setup), setup.factor, methodOf(setup));
}

double mainSpacing(const pattern::Pattern& pattern) {
    double largest = 0;
    for (const auto& piece : pattern.pieces) largest = std::max(largest, piece->spacing);
    return largest;
}

/// All goes of a study: run now, or kept from before.
struct Goes {
    const std::string& name;
    const simulation::Scene& scene;
    std::stop_token stop;
    const std::function<void(const std::string&)>& begin; ///< a go, by its name
    const GoKeeper& keeper;

    [[nodiscard]] Result<GarmentGo> go(const GarmentSetup& setup, double seamTime, double budget,
                                       const std::string& which) const {
        const auto run = [&] { return drapedBy(scene, setup, seamTime, budget, stop); };
        if (!keeper) return run();
        Json of, method, key;
        of.set("name", name).set("layout", std::string(layoutOf(setup))).set("factor", setup.factor);
        of.set("seamTime", seamTime).set("go", which);
        method.set("integrator", std::string(methodOf(setup))).set("budget", budget);
        return keeper(key.set("scene", of).set("method", method), run);
    }
};

/// What becomes of one setup over the repetitions.
struct Attempts {
    GarmentGo first;
    std::vector<double> restSeconds, finishedSeconds;
};

bool isTimedOnce(const Attempts& attempts, const GarmentPlan& plan) {
    return !attempts.first.failure.empty() ||
           (attempts.first.finished && attempts.first.finished->seconds > plan.longRun);
}

/// Whether the same method was given up on a mesh that is no finer.
bool isHopeless(const std::vector<GarmentSetup>& setups, const std::vector<Attempts>& attempts, std::size_t which) {
    for (std::size_t i = 0; i < which; ++i)
        if (setups[i].method == setups[which].method && setups[i].factor >= setups[which].factor &&
            !attempts[i].first.failure.empty())
            return true;
    return false;
}

Result<std::vector<Attempts>> allAttempts(const Goes& goes, const GarmentPlan& plan) {
    std::vector<Attempts> all(plan.setups.size());
    const auto attempt = [&](std::size_t i, int repetition) -> Result<void> {
        Attempts& attempts = all[i];
        goes.begin(nameOf(plan.setups[i]));
        if (isTimedOnce(attempts, plan)) return {};
        if (isHopeless(plan.setups, all, i)) {
            attempts.first.failure = "it was given up on a coarser mesh already";
            return {};
        }
        auto go = goes.go(plan.setups[i], 1, plan.budget, fmt::format("repetition {}", repetition + 1));
        if (!go) return tl::unexpected(go.error());
        if (go->atRest) attempts.restSeconds.push_back(go->atRest->seconds);
        if (go->finished) attempts.finishedSeconds.push_back(go->finished->seconds);
        if (repetition == 0) attempts.first = std::move(*go); // later ones are the same bits again
        return {};
    };
    if (auto done = inTurns(plan.setups.size(), plan.repetitions, attempt); !done) return tl::unexpected(done.error());
    return all;
}

Result<GarmentReference> reference(const Goes& goes, const GarmentPlan& plan) {
    const GarmentSetup setup{.regions = false, .factor = plan.referenceFactor};
    std::vector<std::vector<Quantity>> runs;
    int particles = 0;
    for (int i = 0; i < plan.referenceRuns; ++i) {
        goes.begin(fmt::format("reference {} of {}", i + 1, plan.referenceRuns));
        const auto go =
            goes.go(setup, seamTimeOf(i), std::numeric_limits<double>::infinity(), fmt::format("reference {}", i + 1));
        if (!go) return tl::unexpected(go.error());
        if (!go->finished->status.empty())
            return fail(ErrorCode::notConverged,
                        fmt::format("The reference cannot be relied on: {}.", go->finished->status));
        runs.push_back(go->finished->quantities);
        particles = go->finished->particles;
    }
    GarmentReference found = referenceOf(runs);
    found.spacing = plan.referenceFactor * mainSpacing(goes.scene.pattern);
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
        plan.budget = 600;
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
        GarmentRun run{.drape = {.quantities = quantities}};
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
        const auto &expected = reference.mean[q].value, &found = run.drape.quantities[q].value;
        run.errors.push_back(expected && found ? std::optional(*found - *expected) : std::nullopt);
        if (expected && !found && run.drape.status.empty())
            run.drape.status = fmt::format("no {}", reference.mean[q].name);
        if (!run.errors.back()) continue;
        const double error = std::abs(*run.errors.back());
        squares += error * error / (reference.floor[q] * reference.floor[q]);
        ++count;
        if (reference.mean[q].measure == Measure::length)
            run.lengthError = std::max({run.lengthError, error, reference.floor[q]});
    }
    run.score = count > 0 ? std::sqrt(squares / count) : 0;
}

Result<GarmentAccuracy> studyGarment(const std::string& name, const simulation::Scene& scene, const GarmentPlan& plan,
                                     std::stop_token stop, const Progress& progress, const GoKeeper& keeper) {
    const double all = static_cast<double>(plan.setups.size()) * plan.repetitions + plan.referenceRuns;
    const std::function<void(const std::string&)> begin = [&, done = 0](const std::string& what) mutable {
        report(progress, done++ / all, what);
    };
    const Goes goes{name, scene, stop, begin, keeper};
    GarmentAccuracy study{.name = name, .mainSpacing = mainSpacing(scene.pattern)};
    auto found = reference(goes, plan);
    if (!found) return tl::unexpected(found.error());
    study.reference = std::move(*found);
    auto attempts = allAttempts(goes, plan);
    if (!attempts) return tl::unexpected(attempts.error());
    for (std::size_t i = 0; i < plan.setups.size(); ++i) {
        auto& [first, restSeconds, finishedSeconds] = (*attempts)[i];
        if (!first.finished) {
            study.notRun.push_back({plan.setups[i], first.failure});
            continue;
        }
        const auto append = [&](GarmentDrape& drape, bool finished, const std::vector<double>& seconds) {
            GarmentRun run{.setup = plan.setups[i], .finished = finished, .drape = std::move(drape)};
            run.spacing = run.setup.factor * study.mainSpacing;
            run.time = runTimeOf(seconds);
            run.repetitions = static_cast<int>(seconds.size());
            judge(run, study.reference);
            study.runs.push_back(std::move(run));
        };
        if (first.atRest) append(*first.atRest, false, restSeconds);
        append(*first.finished, true, finishedSeconds);
    }
    return study;
}

} // namespace toile::study
