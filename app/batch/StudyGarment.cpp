// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/StudyGarment.h"

#include "app/batch/Console.h"
#include "app/batch/GoBook.h"
#include "app/batch/Opening.h"
#include "app/batch/StudyFolder.h"
#include "core/base/AtomicFile.h"
#include "core/base/Extension.h"
#include "core/io/DocumentFile.h"
#include "core/study/Advice.h"
#include "core/study/GarmentRecords.h"
#include "core/study/GarmentReport.h"

#include <filesystem>
#include <fmt/format.h>

namespace toile::batch {
namespace {

namespace fs = std::filesystem;

std::string commandOf(const StudyOptions& options) {
    return fmt::format("toile-cli study accuracy {} --{}{} --out {}", options.cases.front(),
                       options.full ? "full" : "quick",
                       options.within ? fmt::format(" --within {:g}", 1e3 * *options.within) : "", options.out);
}

Result<void> run(const StudyOptions& options, std::stop_token stop) {
    const std::string& file = options.cases.front();
    const auto document = io::readDocument(file);
    if (!document) return tl::unexpected(document.error());
    const auto opened = openScene(document->document, file);
    if (!opened) return tl::unexpected(opened.error());
    if (auto made = madeFolder(options.out); !made) return made;
    const study::Circumstances circumstances = circumstancesOf(commandOf(options));
    const study::GarmentPlan plan = study::garmentPlan(opened->scene.pattern, !options.full);
    fmt::print("{} meshes and methods, each {} times, against {} references\n", plan.setups.size(), plan.repetitions,
               plan.referenceRuns);
    ProgressBar bar(options.quiet);
    const fs::path folder(options.out);
    auto book = RecordBook::opened(folder / "drapes.jsonl", circumstances, options.fresh);
    if (!book) return tl::unexpected(book.error());
    const GoBook<study::GarmentGo> goes{*book, hashOf(document->document, opened->scene), circumstances,
                                        "toile-study-drape-1", study::goFrom};
    const auto study =
        study::studyGarment(fs::path(file).stem().string(), opened->scene, plan, stop, bar.progress(), goes);
    if (!study) return tl::unexpected(study.error());
    fmt::print("{}", book->standingText());

    const auto pictures = writeGarmentReport(options.out, *study, options.within, circumstances);
    if (!pictures) return tl::unexpected(pictures.error());
    fmt::print("{}\n", study::verdictOn(*study));
    if (options.within) fmt::print("{}\n", study::suggestion(*study, *options.within));
    fmt::print("{}/report.md{}\n", options.out, *pictures ? "" : withoutPictures);
    return {};
}

} // namespace

Result<bool> writeGarmentReport(const std::string& folder, const study::GarmentAccuracy& study,
                                const std::optional<double>& within, const study::Circumstances& circumstances) {
    const fs::path script = fs::path(folder) / "accuracy.gp";
    const std::string text = study::garmentText(study, within, circumstances);
    if (auto written = writeReport(folder, text, study::recordsOf(study, circumstances)); !written)
        return tl::unexpected(written.error());
    if (study::countedRuns(study).empty()) return true; // there is nothing to be drawn
    if (auto written = writeFileAtomically(script, study::gnuplotScript(study, "accuracy")); !written)
        return tl::unexpected(written.error());
    return drawn(script);
}

bool namesADocument(const StudyOptions& options) {
    return options.cases.size() == 1 && extensionOf(options.cases.front()) == ".toile";
}

int studyGarment(const StudyOptions& options, std::stop_token stop) {
    const auto finished = run(options, stop);
    if (finished) return done;
    printError(io::locatedIn(options.cases.front(), finished.error()));
    return inputWrong;
}

} // namespace toile::batch
