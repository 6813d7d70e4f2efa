// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace toile::batch {

/// Runs this program with these arguments in valgrind and counts the instructions of each call of a function, in their
/// order. function: as callgrind calls it, with its namespaces and the types of its parameters. What valgrind leaves
/// goes to the folder. Error where there is no valgrind, or the program failed in it.
[[nodiscard]] Result<std::vector<double>> instructionsOf(const std::vector<std::string>& arguments,
                                                         const std::string& function,
                                                         const std::filesystem::path& folder);

} // namespace toile::batch
