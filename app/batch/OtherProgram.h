// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace toile::batch {

/// A call of a program that may not be installed.
struct OtherProgram {
    std::vector<std::string> command;   ///< its name first
    std::filesystem::path folder = "."; ///< where it runs
    bool silent = false;                ///< what it prints goes nowhere
};

/// Runs it to its end. False where there is none, or it fails.
[[nodiscard]] bool ran(const OtherProgram& program);

} // namespace toile::batch
