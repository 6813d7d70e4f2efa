// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/RecordBook.h"
#include "app/batch/StudyFolder.h"
#include "app/batch/StudyGarment.h"
#include "core/base/AtomicFile.h"
#include "core/study/AccuracyRecords.h"
#include "core/study/AccuracyReport.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

namespace toile::batch {
namespace {

namespace fs = std::filesystem;

Result<void> writeAll(const fs::path& folder, const std::vector<study::CaseResult>& results,
                      const std::vector<Json>& records, const study::Circumstances& circumstances) {
    for (const study::CaseResult& result : results) {
        const fs::path script = folder / (study::fileNameOf(result) + ".gp");
        if (auto written = writeFileAtomically(script, study::gnuplotScript(result, circumstances.calibration));
            !written)
            return written;
    }
    return writeReport(folder, study::accuracyText(results, circumstances), records);
}

} // namespace

int studyAccuracy(const StudyOptions& options, std::stop_token stop) {
    if (namesADocument(options)) return studyGarment(options, stop);
    if (options.within) {
        printError({ErrorCode::invalidInput, "A setting can be suggested for a document's garment: name one file."});
        return inputWrong;
    }
    const auto names = study::sceneNames();
    for (const std::string& scene : options.cases)
        if (std::ranges::find(names, scene) == names.end()) {
            printError({ErrorCode::notFound,
                        fmt::format("There is no scene \"{}\"; there are {}.", scene, fmt::join(names, ", "))});
            return inputWrong;
        }
    if (auto made = madeFolder(options.out); !made) {
        printError(made.error());
        return inputWrong;
    }
    const study::AccuracyPlan plan = study::accuracyPlan(options.cases, !options.full);
    std::size_t runs = 0;
    for (const auto& one : plan.cases) runs += one.setups.size();
    fmt::print("{} scenes, {} runs, each {} times\n", plan.cases.size(), runs, plan.repetitions);
    const study::Circumstances circumstances =
        circumstancesOf(fmt::format("toile-cli study accuracy{}{} --{} --out {}", options.cases.empty() ? "" : " ",
                                    fmt::join(options.cases, " "), options.full ? "full" : "quick", options.out));
    auto book = RecordBook::opened(fs::path(options.out) / "results.jsonl", circumstances, options.fresh);
    if (!book) {
        printError(book.error());
        return inputWrong;
    }
    ProgressBar bar(options.quiet);
    std::vector<study::CaseResult> results;
    for (std::size_t i = 0; i < plan.cases.size(); ++i) {
        const Progress progress = bar.progress(i, plan.cases.size());
        auto result = book->part(
            study::keysOf(plan.cases[i]), plan.repetitions,
            [&](const auto& known) { return study::resultFrom(plan.cases[i], known); },
            [&] { return study::studied(plan.cases[i], plan.repetitions, stop, progress); },
            [&](const study::CaseResult& run) { return study::recordsOf(run, circumstances); });
        if (!result) {
            printError(result.error());
            return inputWrong;
        }
        results.push_back(std::move(*result));
    }
    fmt::print("{}", book->standingText());
    if (auto written = writeAll(options.out, results, book->records(), circumstances); !written) {
        printError(written.error());
        return inputWrong;
    }
    const bool pictures = std::ranges::all_of(results, [&](const study::CaseResult& result) {
        return drawn(fs::path(options.out) / (study::fileNameOf(result) + ".gp"));
    });
    fmt::print("{}/report.md{}\n", options.out, pictures ? "" : withoutPictures);
    return done;
}

} // namespace toile::batch
