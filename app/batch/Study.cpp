// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/BuildFacts.h"
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "core/base/AtomicFile.h"
#include "core/study/AccuracyReport.h"
#include "core/study/Calibration.h"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <spawn.h>
#include <sys/wait.h>

extern char** environ;

namespace toile::batch {
namespace {

namespace fs = std::filesystem;

std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "an unnamed processor";
}

/// Runs gnuplot on a script in its folder. False where there is none, or it fails.
bool drawn(const fs::path& script) {
    std::string name = "gnuplot", file = script.filename().string();
    char* arguments[]{name.data(), file.data(), nullptr};
    posix_spawn_file_actions_t inFolder;
    posix_spawn_file_actions_init(&inFolder);
    posix_spawn_file_actions_addchdir_np(&inFolder, script.parent_path().c_str());
    pid_t child = 0;
    const bool started = posix_spawnp(&child, "gnuplot", &inFolder, nullptr, arguments, environ) == 0;
    posix_spawn_file_actions_destroy(&inFolder);
    int status = 0;
    return started && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Result<void> writeAll(const fs::path& folder, const std::vector<study::CaseResult>& results,
                      const study::Circumstances& circumstances) {
    std::string lines;
    for (const study::CaseResult& result : results) {
        for (const Json& record : study::recordsOf(result, circumstances)) lines += toLine(record) + '\n';
        const fs::path script = folder / (study::fileNameOf(result) + ".gp");
        if (auto written = writeFileAtomically(script, study::gnuplotScript(result, circumstances.calibration));
            !written)
            return written;
    }
    if (auto written = writeFileAtomically(folder / "results.jsonl", lines); !written) return written;
    return writeFileAtomically(folder / "report.md", study::accuracyText(results, circumstances));
}

} // namespace

int studyAccuracy(const StudyOptions& options, std::stop_token stop) {
    const auto names = study::sceneNames();
    for (const std::string& scene : options.cases)
        if (std::ranges::find(names, scene) == names.end()) {
            printError({ErrorCode::notFound,
                        fmt::format("There is no scene \"{}\"; there are {}.", scene, fmt::join(names, ", "))});
            return inputWrong;
        }
    std::error_code failed;
    fs::create_directories(options.out, failed);
    if (failed) {
        printError({ErrorCode::io, fmt::format("This folder cannot be made: {}.", failed.message()), {options.out}});
        return inputWrong;
    }
    const study::AccuracyPlan plan = study::accuracyPlan(options.cases, !options.full);
    const BuildFacts facts = buildFacts();
    std::size_t runs = 0;
    for (const auto& one : plan.cases) runs += one.setups.size();
    fmt::print("{} scenes, {} runs, each {} times\n", plan.cases.size(), runs, plan.repetitions);
    const study::Circumstances circumstances{
        fmt::format("toile-cli {} ({})", facts.version, facts.commit),
        fmt::format("toile-cli study accuracy{}{} --{} --out {}", options.cases.empty() ? "" : " ",
                    fmt::join(options.cases, " "), options.full ? "full" : "quick", options.out),
        processorName(), study::calibrationSeconds()};
    ProgressBar bar(options.quiet);
    std::vector<study::CaseResult> results;
    for (std::size_t i = 0; i < plan.cases.size(); ++i) {
        const auto whole = [&, shown = bar.progress()](double fraction, const std::string& what) {
            report(shown, (static_cast<double>(i) + fraction) / static_cast<double>(plan.cases.size()), what);
        };
        auto result = study::studied(plan.cases[i], plan.repetitions, stop, whole);
        if (!result) {
            printError(result.error());
            return inputWrong;
        }
        results.push_back(std::move(*result));
    }
    if (auto written = writeAll(options.out, results, circumstances); !written) {
        printError(written.error());
        return inputWrong;
    }
    const bool pictures = std::ranges::all_of(results, [&](const study::CaseResult& result) {
        return drawn(fs::path(options.out) / (study::fileNameOf(result) + ".gp"));
    });
    fmt::print("{}/report.md{}\n", options.out,
               pictures ? "" : ", without pictures: gnuplot (Debian's gnuplot-nox) did not run");
    return done;
}

} // namespace toile::batch
