// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/Cases.h"

#include <algorithm>
#include <fmt/format.h>

namespace toile::study::stability {

std::string_view nameOf(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass: return "PASS";
    case Verdict::passWithWarning: return "PASS-WARN";
    case Verdict::refused: return "REFUSED";
    case Verdict::fail: break;
    }
    return "FAIL";
}

std::vector<Case> allCases() {
    std::vector<Case> all;
    for (const auto& chapter : {stiffnessCases, degenerateCases, loadCases, contactCases, sewingCases, enduranceCases,
                                handCases, fileCases, motionCases, skirtCases, sizeCases, pleatCases})
        for (const Case& one : chapter()) all.push_back(one);
    std::ranges::stable_sort(all, {}, [](const Case& one) { return std::stoi(std::string(one.number.substr(1))); });
    return all;
}

Row judged(std::string number, std::string what, const Watched& run, dynamics::Method method) {
    Row row{std::move(number), std::move(what), run.metrics, Verdict::pass, {}};
    const double growth = run.metrics.energyGrowth.value_or(0);
    if (!run.stopped.empty()) {
        row.verdict = Verdict::fail;
        row.why = run.stopped;
    } else if (!(growth <= allowedGrowth(method))) {
        row.verdict = Verdict::fail;
        row.why = fmt::format("Energy grew by {:.2g} of what was turned over.", growth);
    } else if (!run.solved) {
        row.verdict = Verdict::passWithWarning;
        row.why = "A part of a step was taken unsolved, with the flag for it.";
    }
    return row;
}

Row mustBeRefused(std::string number, std::string what, const std::string& sentence) {
    if (sentence.empty()) return {std::move(number), std::move(what), {}, Verdict::fail, "It was not refused."};
    return {std::move(number), std::move(what), {}, Verdict::refused, sentence};
}

Row tested(std::string number, std::string what, bool passes, std::string why, Metrics metrics) {
    return {std::move(number), std::move(what), std::move(metrics), passes ? Verdict::pass : Verdict::fail,
            passes ? "" : std::move(why)};
}

} // namespace toile::study::stability
