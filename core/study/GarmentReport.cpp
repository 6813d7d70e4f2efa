// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/GarmentReport.h"

#include "core/study/Advice.h"
#include "core/study/ErrorTimePlot.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <map>

namespace toile::study {
namespace {

using dynamics::Method;

/// "xpbd", "xpbd, finished", "static".
std::string wayOf(const GarmentRun& run) {
    return fmt::format("{}{}", methodOf(run.setup), run.finished && run.setup.method ? ", finished" : "");
}

/// "xpbd, finished at 28 mm as drawn"
std::string nameOf(const GarmentRun& run) {
    return fmt::format("{} at {:.3g} mm {}", wayOf(run), 1e3 * run.spacing, layoutOf(run.setup));
}

bool counts(const GarmentRun& run) {
    return run.drape.status.empty();
}

/// The mesh as drawn at this factor by this method; of several factors the finest that was run.
const GarmentRun* runOf(const GarmentAccuracy& study, std::optional<Method> method, bool finished) {
    const GarmentRun* found = nullptr;
    for (const GarmentRun& run : study.runs)
        if (run.setup.regions && run.setup.method == method && run.finished == finished && run.setup.factor >= 1 &&
            (!found || run.setup.factor < found->setup.factor))
            found = &run;
    return found;
}

/// One of the two defaults against all others.
std::string judged(const char* who, const GarmentRun* run, const GarmentAccuracy& study) {
    if (!run) return fmt::format("{} was not run to its end, so nothing is said of it. ", who);
    const std::string name = fmt::format("{} ({}{})", who, nameOf(*run),
                                         run->setup.factor > 1 ? ", the finest mesh on which it was run" : "");
    if (!counts(*run)) return fmt::format("{} does not count ({}). ", name, run->drape.status);
    const CostError own = claimedOf(*run, study.reference);
    const auto front = frontOf(study);
    if (std::ranges::find(front, run) != front.end())
        return fmt::format("{} **lies on the front**: {:.3g} s, {:.2g} floors. ", name, own.cost, own.error);
    std::vector<std::string> better;
    for (const GarmentRun* other : front) {
        const CostError its = claimedOf(*other, study.reference);
        if (its.cost <= own.cost && its.error <= own.error)
            better.push_back(fmt::format("{} ({:.3g} s, {:.2g} floors)", nameOf(*other), its.cost, its.error));
    }
    return fmt::format(
        "{} **does not lie on the front**: it takes {:.3g} s and is {:.2g} floors off; as near or nearer "
        "and cheaper: {}. ",
        name, own.cost, own.error, fmt::join(better, "; "));
}

std::string number(const Quantity& of, double value) {
    return fmt::format("{:.{}f}", shown(of.measure, value), of.measure == Measure::strain ? 2 : 1);
}

void appendReference(std::string& text, const GarmentReference& reference) {
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "| quantity | unit | reference | floor |\n|---|---|---|---|\n");
    for (std::size_t q = 0; q < reference.mean.size(); ++q) {
        const Quantity& quantity = reference.mean[q];
        if (quantity.value)
            fmt::format_to(out, "| {} | {} | {} | {} |\n", quantity.name, unitOf(quantity.measure),
                           number(quantity, *quantity.value), number(quantity, reference.floor[q]));
        else fmt::format_to(out, "| {} | {} | – | {} |\n", quantity.name, unitOf(quantity.measure), quantity.whyAbsent);
    }
}

void appendRuns(std::string& text, const GarmentAccuracy& study, double calibration) {
    const auto out = std::back_inserter(text);
    const auto front = frontOf(study);
    fmt::format_to(out,
                   "\n| method | mesh | spacing mm | particles | simulated s | CPU s | in calibrations | floors off | "
                   "worst length mm | front | |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const GarmentRun& run : study.runs)
        fmt::format_to(out, "| {} | {} | {:.3g} | {} | {:.1f} | {:.3g} | {:.3g} | {:.2g} | {:.2g} | {} | {} |\n",
                       wayOf(run), layoutOf(run.setup), 1e3 * run.spacing, run.drape.particles,
                       run.drape.simulatedSeconds, run.time.least, run.time.least / calibration, run.score,
                       1e3 * run.lengthError, std::ranges::find(front, &run) != front.end() ? "●" : "",
                       !counts(run)           ? run.drape.status
                       : run.time.noisy       ? "noisy"
                       : run.repetitions == 1 ? "timed once"
                                              : "");
    for (const NotRunSetup& setup : study.notRun)
        fmt::format_to(out, "| {} | {} | {:.3g} | | | | | | | | {} |\n", methodOf(setup.setup), layoutOf(setup.setup),
                       1e3 * setup.setup.factor * study.mainSpacing, setup.why);
}

/// What is beyond its floor is bold.
void appendErrors(std::string& text, const GarmentAccuracy& study) {
    const auto out = std::back_inserter(text);
    std::vector<std::size_t> present;
    for (std::size_t q = 0; q < study.reference.mean.size(); ++q)
        if (study.reference.mean[q].value) present.push_back(q);
    fmt::format_to(out, "\n| run |");
    for (const std::size_t q : present)
        fmt::format_to(out, " {}{} |", study.reference.mean[q].key,
                       study.reference.mean[q].measure == Measure::count
                           ? ""
                           : fmt::format(" {}", unitOf(study.reference.mean[q].measure)));
    fmt::format_to(out, "\n|---|{}\n", [&] {
        std::string bars;
        for (std::size_t i = 0; i < present.size(); ++i) bars += "---|";
        return bars;
    }());
    for (const GarmentRun& run : study.runs) {
        fmt::format_to(out, "| {} |", nameOf(run));
        for (const std::size_t q : present) {
            if (!run.errors[q]) {
                text += " – |";
                continue;
            }
            const bool beyond = std::abs(*run.errors[q]) > study.reference.floor[q];
            const std::string value = number(run.drape.quantities[q], *run.errors[q]);
            text += beyond ? " **" + value + "** |" : " " + value + " |";
        }
        text += '\n';
    }
}

} // namespace

CostError claimedOf(const GarmentRun& run, const GarmentReference& reference) {
    return {run.time.least, std::max(run.score, reference.band)};
}

std::vector<const GarmentRun*> frontOf(const GarmentAccuracy& study) {
    const auto runs = countedRuns(study);
    std::vector<CostError> points;
    for (const GarmentRun* run : runs) points.push_back(claimedOf(*run, study.reference));
    std::vector<const GarmentRun*> front;
    for (const int i : paretoFront(points)) front.push_back(runs[static_cast<std::size_t>(i)]);
    return front;
}

std::string verdictOn(const GarmentAccuracy& study) {
    if (const std::size_t noisy = noisyRuns(study); noisy > 0) return tooNoisy(noisy, countedRuns(study).size());
    std::string text = judged("The interactive default", runOf(study, Method::xpbd, true), study);
    text += judged("The accurate default", runOf(study, Method::trBdf2, true), study);
    if (countedRuns(study).empty()) return text + "No run counts: there is no front.";
    std::vector<std::string> front;
    for (const GarmentRun* run : frontOf(study)) front.push_back(nameOf(*run));
    return text + fmt::format("On the front, cheapest first: {}.", fmt::join(front, "; "));
}

std::string suggestion(const GarmentAccuracy& study, double within) {
    const auto& reference = study.reference;
    const auto [counsel, run, quantity] = adviceOn(study, within);
    switch (counsel) {
    case Counsel::meets:
        return fmt::format("Within {:.3g} mm of the reference in every length, cheapest: **{}**, {:.3g} CPU s, within "
                           "{:.2g} mm.",
                           1e3 * within, nameOf(*run), run->time.least, 1e3 * run->lengthError);
    case Counsel::noneMeets:
        return fmt::format("No setting that was run is within {:.3g} mm in every length; the nearest is {}, within "
                           "{:.2g} mm in {:.3g} CPU s.",
                           1e3 * within, nameOf(*run), 1e3 * run->lengthError, run->time.least);
    case Counsel::belowFloor:
        return fmt::format("Within {:.3g} mm nothing can be told: {} differs by {:.2g} mm from one drape of the same "
                           "garment to the next.",
                           1e3 * within, reference.mean[quantity].name, 1e3 * reference.floor[quantity]);
    case Counsel::noLengths: return "It has no lengths that could be compared: no hem, girth, neck or shoulder.";
    case Counsel::tooNoisy: return tooNoisy(noisyRuns(study), countedRuns(study).size());
    case Counsel::noRun: break;
    }
    return "No run came to rest.";
}

std::string garmentText(const GarmentAccuracy& study, const std::optional<double>& within,
                        const Circumstances& circumstances) {
    std::string text;
    const auto& reference = study.reference;
    fmt::format_to(
        std::back_inserter(text),
        "# Error against run time: {}\n\n`{}`, {}, {}. One *calibration*, a loop over a million spring forces, takes "
        "{:.3g} ms.\n\nReference: the mean of {} drapes at {:.3g} mm, uniform ({} particles), by xpbd with the static "
        "finish, their seams closing a little slower or faster (cloth without seams starts up to a millimetre to the "
        "side). The *floor* of a quantity: within it of the mean lie "
        "19 of "
        "20 such drapes; half a millimetre, 0.05 %, 10 cm² or half a fold where that is more. *Floors off*: root mean "
        "square over the quantities of error over floor. The reference's own drapes are up to {:.2g} floors off the "
        "others' "
        "mean; nothing below that is told apart. A method that takes the cloth another way may find another of the "
        "equilibria that friction leaves: that, too, counts as error. CPU times are the least of interleaved "
        "repetitions, and include a look at the result. ● is on the front: no run is both cheaper and nearer. The "
        "error is "
        "numerical; how far the fabric's constants are from the cloth is another matter.\n\n",
        study.name, circumstances.command, circumstances.program, circumstances.processor,
        1e3 * circumstances.calibration, reference.runs, 1e3 * reference.spacing, reference.particles, reference.band);
    text += verdictOn(study) + "\n\n";
    if (within) text += suggestion(study, *within) + "\n\n";
    if (!countedRuns(study).empty()) text += "![error against run time](accuracy.svg)\n\n";
    appendReference(text, reference);
    appendRuns(text, study, circumstances.calibration);
    text += "\nErrors against the reference; bold: beyond the floor.\n";
    appendErrors(text, study);
    return text;
}

std::string gnuplotScript(const GarmentAccuracy& study, const std::string& file) {
    ErrorTimePlot plot{.title = study.name + ", spacing in mm beside the points",
                       .costLabel = "CPU time of the drape, s",
                       .errorLabel = "error of the named quantities, in floors",
                       .band = study.reference.band,
                       .narrow = true};
    std::map<std::string, int> colours;
    std::map<std::string, std::size_t> curves;
    for (const GarmentRun* run : countedRuns(study)) {
        const int colour = colours.try_emplace(wayOf(*run), static_cast<int>(colours.size())).first->second;
        const std::string title = fmt::format("{} ({})", wayOf(*run), layoutOf(run->setup));
        const auto [curve, isNew] = curves.try_emplace(title, plot.curves.size());
        if (isNew) plot.curves.push_back({title, {}, colour, !run->setup.regions});
        const CostError claimed = claimedOf(*run, study.reference);
        plot.curves[curve->second].points.push_back({claimed.cost, claimed.error, 1e3 * run->spacing});
    }
    for (const GarmentRun* run : frontOf(study)) plot.front.push_back(claimedOf(*run, study.reference));
    return gnuplotScript(plot, file);
}

} // namespace toile::study
