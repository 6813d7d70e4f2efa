// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/AccuracyReport.h"

#include "core/study/ErrorTimePlot.h"
#include "core/study/Repetitions.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <map>

namespace toile::study {
namespace {

using dynamics::Method;

constexpr double wantedError = 0.001; ///< the report says what a millimetre costs [m]

/// Runs that may be compared: they ran to the end and were solved.
bool counts(const RunResult& run) {
    return run.failure.empty() && run.solved && std::isfinite(run.error.maximum);
}

std::string statusOf(const RunResult& run) {
    if (!run.failure.empty()) return run.failure;
    if (!run.solved) return "not solved";
    if (run.inBand) return "in the band";
    return run.noisy ? "noisy" : "";
}

std::vector<const RunResult*> countedRuns(const CaseResult& result) {
    std::vector<const RunResult*> runs;
    for (const RunResult& run : result.runs)
        if (counts(run)) runs.push_back(&run);
    return runs;
}

/// A run in the band stands at its edge: so near it surely is, and nearer is not claimed.
double claimedError(const RunResult& run, const CaseResult& result) {
    return std::max(run.error.maximum, bandOf(result.reference));
}

std::vector<CostError> pointsOf(const std::vector<const RunResult*>& runs, const CaseResult& result) {
    std::vector<CostError> points;
    for (const RunResult* run : runs) points.push_back({run->secondsLeast, claimedError(*run, result)});
    return points;
}

std::vector<const RunResult*> frontOf(const CaseResult& result) {
    const auto runs = countedRuns(result);
    std::vector<const RunResult*> front;
    for (const int i : paretoFront(pointsOf(runs, result))) front.push_back(runs[static_cast<std::size_t>(i)]);
    return front;
}

std::map<Method, std::vector<const RunResult*>> byMethod(const std::vector<const RunResult*>& runs) {
    std::map<Method, std::vector<const RunResult*>> methods;
    for (const RunResult* run : runs) methods[run->setup.method].push_back(run);
    return methods;
}

std::string titleOf(const CaseResult& result) {
    if (result.scene.name == "oscillator") return "oscillator";
    return fmt::format("{}, {} × {} cells, {:g} N/m", result.scene.name, result.cells, result.cells,
                       result.scene.stiffness);
}

void appendTable(std::string& text, const CaseResult& result, double calibration) {
    const auto front = frontOf(result);
    fmt::format_to(
        std::back_inserter(text),
        "| method | step ms | error mm | at the end mm | CPU s/s | in calibrations | parts | Newton | factors | "
        "CG | energy % | front | |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const RunResult& run : result.runs) {
        const bool onFront = std::ranges::find(front, &run) != front.end();
        fmt::format_to(std::back_inserter(text),
                       "| {} | {:.4g} | {:.4g} | {:.4g} | {:.4g} | {:.3g} | {} | {} | {} | {} | {:.2g} | {} | {} |\n",
                       dynamics::nameOf(run.setup.method), 1e3 * run.step, 1e3 * run.error.maximum, 1e3 * run.error.rms,
                       run.secondsLeast, run.secondsLeast / calibration, run.report.parts, run.report.newtonIterations,
                       run.report.factorizations, run.report.gradientIterations, 100 * run.energyChange,
                       onFront ? "●" : "", statusOf(run));
    }
}

void appendOrders(std::string& text, const CaseResult& result) {
    fmt::format_to(std::back_inserter(text), "\n| method | observed order | CPU s/s for 1 mm |\n|---|---|---|\n");
    for (const auto& [method, runs] : byMethod(countedRuns(result))) {
        std::vector<double> steps, errors;
        for (const RunResult* run : runs) {
            if (run->inBand) continue;
            steps.push_back(run->step);
            errors.push_back(run->error.maximum);
        }
        const double order = observedOrder(steps, errors), cost = costOf(wantedError, pointsOf(runs, result));
        fmt::format_to(std::back_inserter(text), "| {} | {} | {} |\n", dynamics::nameOf(method),
                       std::isfinite(order) ? fmt::format("{:.2f}", order) : "–",
                       std::isfinite(cost) ? fmt::format("{:.4g}", cost) : "not reached");
    }
}

/// What may be said, and what may not.
void appendConclusion(std::string& text, const CaseResult& result) {
    const auto runs = countedRuns(result);
    const auto noisy = std::ranges::count_if(runs, [](const RunResult* run) { return run->noisy; });
    text += '\n';
    if (noisy > 0) {
        text += tooNoisy(static_cast<std::size_t>(noisy), runs.size()) + "\n\n";
        return;
    }
    std::pair<double, std::string> cheapest{std::numeric_limits<double>::infinity(), ""};
    for (const auto& [method, of] : byMethod(runs))
        if (const double cost = costOf(wantedError, pointsOf(of, result)); cost < cheapest.first)
            cheapest = {cost, std::string(dynamics::nameOf(method))};
    if (cheapest.second.empty()) text += "No method came within 1 mm.\n\n";
    else
        fmt::format_to(std::back_inserter(text),
                       "A millimetre is cheapest by {}: {:.3g} CPU s per simulated second.\n\n", cheapest.second,
                       cheapest.first);
}

} // namespace

std::string fileNameOf(const CaseResult& result) {
    return result.scene.name == "oscillator" ? result.scene.name
                                             : fmt::format("{}-{:g}", result.scene.name, result.stiffnessFactor);
}

std::string accuracyText(const std::vector<CaseResult>& results, const Circumstances& circumstances) {
    std::string text;
    const auto out = std::back_inserter(text);
    fmt::format_to(
        out,
        "# Error against run time\n\n`{}`, {}, {}. One *calibration*, a loop over a million spring forces, takes "
        "{:.3g} ms.\n\n"
        "The error is the largest mass-weighted root mean square distance to the reference over {} times, on the "
        "same mesh: what the division of time costs, and nothing else. A run *in the band* is nearer to the "
        "reference than three times the reference's own error; it stands at the band's edge, and no order is read from "
        "it. Times are "
        "the least of interleaved repetitions on one thread. ● is on the front: no run is both cheaper and nearer.\n",
        circumstances.command, circumstances.program, circumstances.processor, 1e3 * circumstances.calibration,
        sampleCount);
    for (const CaseResult& result : results) {
        fmt::format_to(out,
                       "\n## {}\n\n{} particles, {:g} s. Reference: {} at {:.3g} ms, own error {:.2g} mm.\n\n![error "
                       "against run time]({}.svg)\n\n",
                       titleOf(result), result.scene.model.particleCount(), result.scene.duration,
                       dynamics::nameOf(result.reference.setup.method),
                       1e3 * result.scene.duration / result.reference.setup.steps, 1e3 * result.reference.selfError,
                       fileNameOf(result));
        appendTable(text, result, circumstances.calibration);
        appendOrders(text, result);
        appendConclusion(text, result);
    }
    return text;
}

std::string gnuplotScript(const CaseResult& result, double calibration) {
    ErrorTimePlot plot{.title = titleOf(result),
                       .costLabel = "CPU time of a simulated second, in calibrations",
                       .errorLabel = "largest rms distance to the reference, mm",
                       .band = 1e3 * bandOf(result.reference)};
    const auto point = [&](const RunResult& run) {
        return PlotCurve::Point{run.secondsLeast / calibration, 1e3 * claimedError(run, result), 1e3 * run.step};
    };
    for (const auto& [method, runs] : byMethod(countedRuns(result))) {
        PlotCurve& curve = plot.curves.emplace_back();
        curve.title = dynamics::nameOf(method);
        for (const RunResult* run : runs) curve.points.push_back(point(*run));
    }
    for (const RunResult* run : frontOf(result)) plot.front.push_back({point(*run).cost, point(*run).error});
    return gnuplotScript(plot, fileNameOf(result));
}

} // namespace toile::study
