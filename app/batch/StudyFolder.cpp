// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/StudyFolder.h"

#include "app/batch/BuildFacts.h"
#include "app/batch/HtmlReport.h"
#include "app/batch/OtherProgram.h"
#include "core/base/AtomicFile.h"
#include "core/study/Calibration.h"

#include <fmt/format.h>
#include <fstream>
#include <thread>

namespace toile::batch {
namespace {

namespace fs = std::filesystem;

std::string processorName() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "an unnamed processor";
}

} // namespace

Result<void> madeFolder(const std::string& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) return fail(ErrorCode::io, fmt::format("This folder cannot be made: {}.", failed.message()), {folder});
    return {};
}

study::Circumstances circumstancesOf(std::string command) {
    const BuildFacts facts = buildFacts();
    const double load = study::machineLoad(); // before the calibration adds to it
    return {fmt::format("toile-cli {} ({})", facts.version, facts.commit),
            std::move(command),
            processorName(),
            study::calibrationSeconds(),
            static_cast<int>(std::thread::hardware_concurrency()),
            load};
}

Result<void> writeReport(const fs::path& folder, const std::string& text, const std::vector<Json>& records) {
    std::string lines;
    for (const Json& record : records) lines += toLine(record) + '\n';
    if (auto written = writeFileAtomically(folder / "results.jsonl", lines); !written) return written;
    if (auto written = writeFileAtomically(folder / "report.html", htmlReport(text)); !written) return written;
    return writeFileAtomically(folder / "report.md", text);
}

Result<std::vector<Json>> recordsIn(const fs::path& report) {
    std::error_code ignored; // what cannot be looked at cannot be opened either
    const fs::path path = fs::is_directory(report, ignored) ? report / "results.jsonl" : report;
    std::ifstream file(path);
    if (!file) return fail(ErrorCode::io, "There is no such report.", {path.string()});
    std::vector<Json> records;
    int number = 0;
    for (std::string line; std::getline(file, line);) {
        ++number;
        auto record = parseJson(line, path.string());
        if (!record) return fail(record.error().code, record.error().text, {path.string(), number});
        records.push_back(std::move(*record));
    }
    return records;
}

bool drawn(const fs::path& script) {
    return ran({.command = {"gnuplot", script.filename().string()}, .folder = script.parent_path()});
}

} // namespace toile::batch
