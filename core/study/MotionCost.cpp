// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/MotionCost.h"

#include "core/study/Calibration.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace toile::study {
namespace {

using dynamics::Method;

constexpr double moved = 0.2; ///< [s]

Result<double> secondsOf(const Layout& layout, MotionCost& cost, std::stop_token stop) {
    auto simulation = simulation::Simulation::create(layout.scene);
    if (!simulation) return tl::unexpected(simulation.error());
    simulation->drapeWith(cost.method);
    const int frames = static_cast<int>(std::lround(moved / layout.scene.settings.frameStep));
    const double start = threadSeconds();
    for (int frame = 0; frame < frames; ++frame)
        if (auto done = simulation->advance(stop); !done) return tl::unexpected(done.error());
    const double seconds = (threadSeconds() - start) / moved;
    int parts = 0;
    for (const simulation::PhaseRun& phase : simulation->phases()) parts += phase.steps.parts;
    cost.parts = static_cast<int>(std::lround(parts / moved));
    cost.particles = simulation->garment().model.particleCount();
    return seconds;
}

const MotionCost* costOf(const std::vector<MotionCost>& costs, LayoutKind layout, Method method) {
    for (const MotionCost& cost : costs)
        if (cost.layout == layout && cost.method == method && cost.failure.empty()) return &cost;
    return nullptr;
}

std::string cellOf(const MotionCost* cost) {
    if (!cost) return "–";
    return fmt::format("{:.3g} ({}){}", cost->time.least, cost->parts, cost->time.noisy ? " noisy" : "");
}

} // namespace

Result<std::vector<MotionCost>> motionCosts(const simulation::Scene& scene, const RegionsStudy& study,
                                            std::stop_token stop, const Progress& progress) {
    std::vector<MotionCost> costs;
    if (!scene.pattern.seams.empty()) return costs;
    std::vector<Layout> layouts;
    for (const LayoutResult& result : study.layouts)
        layouts.push_back(result.kind == LayoutKind::asManyPoints
                              ? asManyPoints(scene, study.find(LayoutKind::coarse)->particles,
                                             study.find(LayoutKind::regions)->particles)
                              : layoutOf(scene, result.kind));
    for (const Layout& layout : layouts)
        for (const Method method : motionMethods) costs.push_back({.layout = layout.kind, .method = method});
    std::vector<std::vector<double>> seconds(costs.size());
    const auto run = [&](std::size_t i, int) -> Result<void> {
        MotionCost& cost = costs[i];
        if (!cost.failure.empty()) return {};
        report(progress, static_cast<double>(i) / static_cast<double>(costs.size()),
               fmt::format("{}, moved by {}", nameOf(cost.layout), dynamics::nameOf(cost.method)));
        const auto taken = secondsOf(layouts[i / motionMethods.size()], cost, stop);
        if (!taken && taken.error().code == ErrorCode::cancelled) return tl::unexpected(taken.error());
        if (taken) seconds[i].push_back(*taken);
        else cost.failure = taken.error().text;
        return {};
    };
    if (auto done = inTurns(costs.size(), study.repetitions, run); !done) return tl::unexpected(done.error());
    for (std::size_t i = 0; i < costs.size(); ++i) costs[i].time = runTimeOf(seconds[i]);
    return costs;
}

std::string motionText(const std::vector<MotionCost>& costs) {
    if (costs.empty()) return "";
    std::string text = fmt::format("\n## What motion costs\n\nCPU seconds of one simulated second, of the first {:g} "
                                   "s, and steps or substeps of a second.\n\n| layout | particles |",
                                   moved);
    const auto out = std::back_inserter(text);
    for (const Method method : motionMethods) fmt::format_to(out, " {} |", dynamics::nameOf(method));
    text += "\n|---|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < costs.size(); i += motionMethods.size()) {
        fmt::format_to(out, "| {} | {} |", nameOf(costs[i].layout), costs[i].particles);
        for (const Method method : motionMethods)
            fmt::format_to(out, " {} |", cellOf(costOf(costs, costs[i].layout, method)));
        text += '\n';
    }
    text += '\n';
    for (const Method method : motionMethods) {
        const auto* regions = costOf(costs, LayoutKind::regions, method);
        const auto* equal = costOf(costs, LayoutKind::asManyPoints, method);
        const auto* fine = costOf(costs, LayoutKind::fine, method);
        if (!regions || !equal || !fine || regions->time.noisy || equal->time.noisy || fine->time.noisy) continue;
        fmt::format_to(
            out,
            "By {} the regions take {:.2g} times the time of as many particles spread evenly, and {:.2g} times "
            "that of the uniform fine mesh.\n",
            dynamics::nameOf(method), regions->time.least / equal->time.least, regions->time.least / fine->time.least);
    }
    for (const MotionCost& cost : costs)
        if (!cost.failure.empty())
            fmt::format_to(out, "\n{} by {}: {}\n", nameOf(cost.layout), dynamics::nameOf(cost.method), cost.failure);
    return text;
}

} // namespace toile::study
