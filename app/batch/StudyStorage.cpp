// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Commands.h"
#include "app/batch/Console.h"
#include "app/batch/StudyFolder.h"
#include "core/io/DocumentFile.h"

#include <fmt/format.h>

namespace toile::batch {
namespace {

std::string commandOf(const StorageOptions& options) {
    std::string command = "toile-cli study storage " + options.file;
    for (const study::FineBox& box : options.fine)
        command += fmt::format(" --fine \"{}={},{},{},{}\"", box.piece, box.left, box.bottom, box.right, box.top);
    return command + " --out " + options.out;
}

Result<void> run(const StorageOptions& options) {
    const auto opened = io::readDocument(options.file);
    if (!opened) return tl::unexpected(opened.error());
    Result<pattern::Pattern> pattern = opened->document.pattern;
    if (!options.fine.empty()) pattern = study::withFineBoxes(*pattern, options.fine);
    if (!pattern) return tl::unexpected(pattern.error());
    const auto study = study::studyStorage(*pattern);
    if (!study) return tl::unexpected(study.error());
    if (auto made = madeFolder(options.out); !made) return made;
    const study::Circumstances circumstances = circumstancesOf(commandOf(options));
    const std::string text = study::storageText(*study, options.file, circumstances);
    if (auto written = writeReport(options.out, text, study::recordsOf(*study, options.file, circumstances)); !written)
        return written;
    fmt::print("{}", text);
    return {};
}

} // namespace

int studyStorage(const StorageOptions& options) {
    const auto finished = run(options);
    if (finished) return done;
    printError(io::locatedIn(options.file, finished.error()));
    return inputWrong;
}

} // namespace toile::batch
