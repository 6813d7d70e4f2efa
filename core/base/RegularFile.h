// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace toile {

/// The bytes of a regular file. A folder, a pipe or a device is refused without waiting for it; so is a file longer
/// than the limit [bytes]. An empty file gives an empty string.
[[nodiscard]] Result<std::string> readRegularFile(const std::filesystem::path& path, std::uint64_t limit);

} // namespace toile
