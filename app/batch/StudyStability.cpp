// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/StudyCases.h"
#include "app/batch/StudyFolder.h"
#include "core/base/AtomicFile.h"
#include "core/study/stability/Report.h"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::batch {
namespace {

using namespace study::stability;

std::string commandOf(const CasesOptions& options) {
    std::string command = "toile-cli study stability";
    if (!options.only.empty()) command += fmt::format(" --only {}", fmt::join(options.only, ","));
    if (options.quick) command += " --quick";
    return options.out.empty() ? command : command + " --out " + options.out;
}

/// Table, records and the map with its picture. False where gnuplot did not draw it.
Result<bool> written(const CasesOptions& options, const Findings& all) {
    const std::filesystem::path folder(options.out);
    const study::Circumstances circumstances = circumstancesOf(commandOf(options));
    if (auto done = writeReport(folder, stabilityText(all.rows, !all.map.empty(), circumstances),
                                recordsOf(all.rows, all.map, circumstances));
        !done)
        return tl::unexpected(done.error());
    if (all.map.empty()) return true;
    const auto script = folder / "stiffness-map.gp";
    if (auto done = writeFileAtomically(script, mapScript(all.map)); !done) return tl::unexpected(done.error());
    return drawn(script);
}

Result<Findings> run(const CasesOptions& options, std::stop_token stop) {
    const auto chosen = chosenOf(allCases(), std::vector<Case>{}, options.only, "stability");
    if (!chosen) return tl::unexpected(chosen.error());
    if (!options.out.empty())
        if (auto made = madeFolder(options.out); !made) return tl::unexpected(made.error());
    Findings all;
    for (const Case& one : chosen->cases) {
        if (stop.stop_requested()) return fail(ErrorCode::cancelled, "It was stopped.");
        Findings found = one.run({options.quick});
        for (const Row& row : found.rows) fmt::print("{}\n", lineOf(row));
        std::fflush(stdout);
        all.rows.insert(all.rows.end(), found.rows.begin(), found.rows.end());
        all.map.insert(all.map.end(), found.map.begin(), found.map.end());
    }
    fmt::print("{}.\n", summaryOf(all.rows));
    if (options.out.empty()) return all;
    const auto pictures = written(options, all);
    if (!pictures) return tl::unexpected(pictures.error());
    fmt::print("{}/report.md{}\n", options.out, *pictures ? "" : withoutPictures);
    return all;
}

} // namespace

int studyStability(const CasesOptions& options, std::stop_token stop) {
    const auto all = run(options, stop);
    if (all) return std::ranges::count(all->rows, Verdict::fail, &Row::verdict) == 0 ? done : goalMissed;
    printError(all.error());
    return inputWrong;
}

} // namespace toile::batch
