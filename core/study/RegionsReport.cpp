// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/RegionsReport.h"

#include "core/study/ErrorTimePlot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::study {
namespace {

std::size_t noisyOf(const RegionsStudy& study) {
    return static_cast<std::size_t>(
        std::ranges::count_if(study.layouts, [](const LayoutResult& layout) { return layout.time.noisy; }));
}

/// "and 0.21 times the CPU time "; nothing where a time is noisy.
std::string timesOf(const RegionsStudy& study) {
    if (noisyOf(study) > 0) return "";
    return fmt::format("and {:.2f} times the CPU time ",
                       study.find(LayoutKind::regions)->time.least / study.find(LayoutKind::fine)->time.least);
}

Json recordOf(const LayoutResult& layout, std::string_view name) {
    Json method, result, cost, record;
    method.set("layout", std::string(name)).set("spacing", layout.spacing);
    result.set("rmsError", layout.rms).set("maximumError", layout.maximum).set("strainRms", layout.strain.rms);
    result.set("energy", layout.energy);
    cost.set("particles", layout.particles).set("springs", layout.springs).set("bytes", layout.bytes);
    cost.set("cpuSecondsMinimum", layout.time.least).set("cpuSecondsMedian", layout.time.median);
    record.set("method", method).set("result", result).set("cost", cost);
    return record.set("status", layout.atRest ? "done" : "not at rest");
}

} // namespace

std::string verdictOn(const RegionsStudy& study) {
    const LayoutResult &coarse = *study.find(LayoutKind::coarse), &regions = *study.find(LayoutKind::regions),
                       &equal = *study.find(LayoutKind::asManyPoints), &fine = *study.find(LayoutKind::fine);
    std::string text;
    const auto compared = [&](const LayoutResult& other, const char* than) {
        const double gain = other.rms - regions.rms;
        if (std::abs(gain) <= study.floor) return fmt::format("as near to the reference as {}", than);
        return fmt::format("{:.2g} mm {} than {}", 1e3 * std::abs(gain),
                           gain > 0 ? "nearer to the reference" : "farther off", than);
    };
    text =
        fmt::format("The regions are {}, and {}. They take {:.2f} times the particles {}of the uniform fine mesh, and "
                    "are {}. ",
                    compared(coarse, "the uniform coarse mesh"), compared(equal, "a uniform mesh of as many particles"),
                    static_cast<double>(regions.particles) / fine.particles, timesOf(study), compared(fine, "it"));
    for (const LayoutKind kind : {LayoutKind::paper, LayoutKind::elsewhere})
        if (const LayoutResult* other = study.find(kind))
            text += fmt::format("They are {}. ",
                                compared(*other, kind == LayoutKind::paper ? "the same regions by the paper's rule"
                                                                           : "the same regions in a wrong place"));
    text += fmt::format("Differences of less than the floor, {:.2g} mm, are none. ", 1e3 * study.floor);
    const bool better = regions.rms + study.floor < equal.rms, worse = equal.rms + study.floor < regions.rms;
    text += better  ? "**Here the regions pay.**"
            : worse ? "**Here the regions do not pay: the same particles spread evenly do better.**"
                    : "**Here it makes no difference where the particles are.**";
    if (const std::size_t noisy = noisyOf(study)) text += ' ' + tooNoisy(noisy, study.layouts.size());
    return text;
}

std::string regionsText(const RegionsStudy& study, const std::string& document, const Circumstances& circumstances) {
    std::string text = fmt::format(
        "# Regions: {}\n\n`{}`, {}, {}. Distance to a uniform mesh of {:.3g} mm ({} particles) at {} common material "
        "points; with its lines 4 % closer that mesh differs from itself by {:.3g} mm (rms): the floor. CPU times are "
        "the least and the median of {} runs that take turns; of the reference, of one.\n\n| layout | least spacing mm "
        "| "
        "particles | springs | KiB | CPU s | median | rms mm | largest mm | rms strain % | energy J | at rest |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n",
        document, circumstances.command, circumstances.program, circumstances.processor, 1e3 * study.reference.spacing,
        study.reference.particles, study.points, 1e3 * study.floor, study.repetitions);
    const auto row = [&](const LayoutResult& layout, std::string_view name, const std::string& rms,
                         const std::string& largest) {
        text += fmt::format("| {} | {:.3g} | {} | {} | {} | {:.3g} | {:.3g} | {} | {} | {:.3g} | {:.5g} | {} |\n", name,
                            1e3 * layout.spacing, layout.particles, layout.springs, layout.bytes / 1024,
                            layout.time.least, layout.time.median, rms, largest, 100 * layout.strain.rms, layout.energy,
                            layout.atRest ? "yes" : "no");
    };
    for (const LayoutResult& layout : study.layouts)
        row(layout, nameOf(layout.kind), fmt::format("{:.3g}", 1e3 * layout.rms),
            fmt::format("{:.3g}", 1e3 * layout.maximum));
    row(study.reference, "reference", "–", "–");
    for (const NotLaidOut& one : study.notRun) text += fmt::format("| {} | not run: {} |\n", nameOf(one.kind), one.why);
    text += "\n![distance to the reference against particles](regions.svg)\n\n";
    return text + verdictOn(study) + "\n\n## What deforms\n\nOn the uniform fine mesh:\n\n" +
           deformationText(study.parts);
}

std::vector<Json> recordsOf(const RegionsStudy& study, const std::string& document,
                            const Circumstances& circumstances) {
    Json scene, reference;
    scene.set("name", document);
    reference.set("spacing", study.reference.spacing).set("selfError", study.floor).set("points", study.points);
    std::vector<Json> records;
    for (const LayoutResult& layout : study.layouts) records.push_back(recordOf(layout, nameOf(layout.kind)));
    records.push_back(recordOf(study.reference, "reference"));
    for (Json& record : records) {
        record.set("scene", scene).set("reference", reference);
        note(record, "toile-regions-1", circumstances);
    }
    return records;
}

std::string gnuplotScript(const RegionsStudy& study, const std::string& name, const std::string& file) {
    ErrorTimePlot plot{.title = name + ", least spacing in mm beside the points",
                       .costLabel = "particles",
                       .errorLabel = "rms distance to the reference, mm",
                       .curves = {{.title = "uniform"}},
                       .band = 1e3 * study.floor,
                       .narrow = true};
    std::vector<CostError> points;
    for (const LayoutResult& layout : study.layouts) {
        if (layout.rms == 0) continue; // it is the reference
        const CostError claimed{static_cast<double>(layout.particles), 1e3 * std::max(layout.rms, study.floor)};
        if (!isUniform(layout.kind)) plot.curves.push_back({.title = std::string(nameOf(layout.kind))});
        auto& curve = isUniform(layout.kind) ? plot.curves.front() : plot.curves.back();
        curve.points.push_back({claimed.cost, claimed.error, 1e3 * layout.spacing});
        points.push_back(claimed);
    }
    for (const int i : paretoFront(points)) plot.front.push_back(points[static_cast<std::size_t>(i)]);
    return gnuplotScript(plot, file);
}

} // namespace toile::study
