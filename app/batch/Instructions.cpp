// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch/Instructions.h"

#include "app/batch/OtherProgram.h"

#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <optional>

namespace toile::batch {
namespace {

namespace fs = std::filesystem;

/// What callgrind's file says in all: "totals: 123".
std::optional<double> totalIn(const fs::path& dump) {
    std::ifstream file(dump);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("totals: ")) return std::strtod(line.c_str() + 8, nullptr);
    return std::nullopt;
}

} // namespace

Result<std::vector<double>> instructionsOf(const std::vector<std::string>& arguments, const std::string& function,
                                           const fs::path& folder) {
    const std::string dump = (folder / "callgrind").string();
    std::vector<std::string> command{"valgrind",
                                     "--tool=callgrind",
                                     "--callgrind-out-file=" + dump,
                                     "--toggle-collect=" + function,
                                     "--dump-after=" + function,
                                     fs::read_symlink("/proc/self/exe").string()};
    command.insert(command.end(), arguments.begin(), arguments.end());
    if (!ran({.command = std::move(command), .silent = true}))
        return fail(ErrorCode::unsupported,
                    "Instructions are counted by valgrind (Debian's valgrind), which did not run "
                    "through. Without --count the study does all the rest.");
    std::vector<double> counts;
    while (const auto total = totalIn(fmt::format("{}.{}", dump, counts.size() + 1))) counts.push_back(*total);
    return counts;
}

} // namespace toile::batch
