// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/GoBook.h"
#include "app/batch/Opening.h"
#include "app/batch/StudyFolder.h"
#include "core/base/AtomicFile.h"
#include "core/io/DocumentFile.h"
#include "core/study/MotionCost.h"
#include "core/study/RegionsReport.h"

#include <fmt/format.h>

namespace toile::batch {

int studyRegions(const StudyOptions& options, std::stop_token stop) {
    const std::string& file = options.cases.front();
    const auto refuse = [&file](const Error& error) {
        printError(io::locatedIn(file, error));
        return static_cast<int>(inputWrong);
    };
    auto document = io::readDocument(file);
    if (!document) return refuse(document.error());
    auto opened = openScene(document->document, file);
    if (!opened) return refuse(opened.error());
    if (auto made = madeFolder(options.out); !made) return refuse(made.error());

    const double finest = study::finestSpacing(opened->scene.pattern).value_or(0);
    ProgressBar bar(options.quiet);
    const study::RegionsSettings settings{.referenceSpacing = options.full ? finest / 2 : finest,
                                          .repetitions = options.full ? 5 : 3,
                                          .sewing = {.hold = 0}};
    const study::Circumstances circumstances = circumstancesOf(
        fmt::format("toile-cli study regions {} --{} --out {}", file, options.full ? "full" : "quick", options.out));
    auto book = RecordBook::opened(std::filesystem::path(options.out) / "drapes.jsonl", circumstances, options.fresh);
    if (!book) return refuse(book.error());
    const GoBook<study::LayoutGo> goes{*book, hashOf(document->document, opened->scene), circumstances,
                                       "toile-study-layout-1", study::layoutGoFrom};
    auto study = study::studyRegions(opened->scene, settings, stop, bar.progress(), goes);
    if (!study) {
        Error error = study.error();
        if (error.place.file.empty()) error.place.file = file;
        return refuse(error);
    }
    fmt::print("{}", book->standingText());
    const auto motion = study::motionCosts(opened->scene, *study, stop, bar.progress());
    if (!motion) return refuse(motion.error());
    if (auto written =
            writeReport(options.out, study::regionsText(*study, file, circumstances) + study::motionText(*motion),
                        study::recordsOf(*study, file, circumstances));
        !written)
        return refuse(written.error());
    const std::filesystem::path script = std::filesystem::path(options.out) / "regions.gp";
    const std::string name = std::filesystem::path(file).stem().string();
    if (auto written = writeFileAtomically(script, study::gnuplotScript(*study, name, "regions")); !written)
        return refuse(written.error());
    fmt::print("{}\n{}/report.md{}\n", study::verdictOn(*study), options.out, drawn(script) ? "" : withoutPictures);
    return done;
}

} // namespace toile::batch
