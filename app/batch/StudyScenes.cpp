// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/RecordBook.h"
#include "app/batch/SceneCases.h"
#include "app/batch/StudyFolder.h"
#include "core/study/scenes/Report.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace toile::batch {
namespace {

using namespace study::scenes;

Result<std::vector<Case>> chosenCases(const StudyOptions& options) {
    const auto names = sceneGroups();
    for (const std::string& name : options.cases)
        if (std::ranges::find(names, name) == names.end())
            return fail(ErrorCode::notFound,
                        fmt::format("There is no scene \"{}\"; there are {}.", name, fmt::join(names, ", ")));
    std::vector<Case> chosen;
    for (const std::string_view name : names) {
        if (!options.cases.empty() && std::ranges::find(options.cases, name) == options.cases.end()) continue;
        auto cases = sceneCases(name, options.full);
        if (!cases) return tl::unexpected(cases.error());
        for (Case& one : *cases) chosen.push_back(std::move(one));
    }
    return chosen;
}

std::string commandOf(const StudyOptions& options) {
    std::string command = "toile-cli study scenes";
    for (const std::string& name : options.cases) command += ' ' + name;
    if (!options.full) command += " --quick";
    if (options.repetitions > 0) command += fmt::format(" --repetitions {}", options.repetitions);
    return fmt::format("{} --out {}", command, options.out);
}

Result<std::vector<Outcome>> run(const StudyOptions& options, const std::stop_token& stop) {
    const auto cases = chosenCases(options);
    if (!cases) return tl::unexpected(cases.error());
    if (auto made = madeFolder(options.out); !made) return tl::unexpected(made.error());
    const study::Circumstances circumstances = circumstancesOf(commandOf(options));
    auto book = RecordBook::opened(std::filesystem::path(options.out) / "results.jsonl", circumstances, options.fresh);
    if (!book) return tl::unexpected(book.error());
    ProgressBar bar(options.quiet);
    std::vector<Outcome> outcomes;
    for (const Case& one : *cases) {
        Effort effort{.stop = stop};
        if (options.repetitions > 0) effort.repetitions = options.repetitions;
        effort.progress = bar.progress(outcomes.size(), cases->size());
        auto outcome = book->part(
            keysOf(one), effort.repetitions,
            [&](const auto& known) -> Result<Outcome> { return outcomeFrom(one, known); },
            [&]() -> Result<Outcome> {
                auto rows = one.run(effort);
                if (!rows) return tl::unexpected(rows.error());
                return Outcome{one.name, one.about, std::move(*rows)};
            },
            [&](const Outcome& done) { return recordsOf(done, circumstances); });
        if (!outcome) return tl::unexpected(outcome.error());
        outcomes.push_back(std::move(*outcome));
    }
    fmt::print("{}", book->standingText());
    if (auto written = writeReport(options.out, scenesText(outcomes, circumstances), book->records()); !written)
        return tl::unexpected(written.error());
    return outcomes;
}

} // namespace

int studyScenes(const StudyOptions& options, std::stop_token stop) {
    const auto outcomes = run(options, stop);
    if (!outcomes) {
        printError(outcomes.error());
        return inputWrong;
    }
    fmt::print("{}\n{}/report.md\n", summaryOf(*outcomes), options.out);
    return allReached(*outcomes) ? done : goalMissed;
}

} // namespace toile::batch
