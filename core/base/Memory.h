// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

namespace toile {

/// What the machine would still give this process [B]: the least of what is free or soon can be, of what its control
/// group may still have, and of what its own limits leave; the largest number where none of them is known.
/// root: under which /proc and /sys are read.
[[nodiscard]] std::size_t availableMemory(const std::filesystem::path& root = "/");

} // namespace toile
