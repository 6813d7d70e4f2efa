// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/StudyFolder.h"

#include "app/batch/BuildFacts.h"
#include "core/study/Calibration.h"

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

} // namespace

Result<void> madeFolder(const std::string& folder) {
    std::error_code failed;
    fs::create_directories(folder, failed);
    if (failed) return fail(ErrorCode::io, fmt::format("This folder cannot be made: {}.", failed.message()), {folder});
    return {};
}

study::Circumstances circumstancesOf(std::string command) {
    const BuildFacts facts = buildFacts();
    return {fmt::format("toile-cli {} ({})", facts.version, facts.commit), std::move(command), processorName(),
            study::calibrationSeconds()};
}

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

} // namespace toile::batch
