// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/StudyCases.h"
#include "app/batch/StudyFolder.h"
#include "core/study/validation/Report.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::batch {
namespace {

using namespace study::validation;

std::string commandOf(const CasesOptions& options) {
    std::string command = "toile-cli study validation";
    if (!options.only.empty()) command += fmt::format(" --only {}", fmt::join(options.only, ","));
    return options.out.empty() ? command : command + " --out " + options.out;
}

Result<std::vector<Outcome>> run(const CasesOptions& options, std::stop_token stop) {
    const auto chosen = chosenOf(allCases(), casesNotOffered(), options.only, "validation");
    if (!chosen) return tl::unexpected(chosen.error());
    if (!options.out.empty())
        if (auto made = madeFolder(options.out); !made) return tl::unexpected(made.error());
    std::vector<Outcome> outcomes;
    for (const Case& one : chosen->cases) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "It was stopped.");
        outcomes.push_back({one, rowsOf(one)});
        for (const Row& row : outcomes.back().rows) fmt::print("{}\n", lineOf(row));
        std::fflush(stdout);
    }
    for (const NotOffered& one : chosen->others)
        fmt::print("{:<5} {}: not offered. {}\n", one.number, one.title, one.reason);
    fmt::print("{}\n", summaryOf(outcomes, chosen->others));
    if (options.out.empty()) return outcomes;

    const study::Circumstances circumstances = circumstancesOf(commandOf(options));
    if (auto written = writeReport(options.out, validationText(outcomes, chosen->others, circumstances),
                                   recordsOf(outcomes, chosen->others, circumstances));
        !written)
        return tl::unexpected(written.error());
    fmt::print("{}/report.md\n", options.out);
    return outcomes;
}

} // namespace

int studyValidation(const CasesOptions& options, std::stop_token stop) {
    const auto outcomes = run(options, stop);
    if (outcomes) return allPass(*outcomes) ? done : goalMissed;
    printError(outcomes.error());
    return inputWrong;
}

} // namespace toile::batch
