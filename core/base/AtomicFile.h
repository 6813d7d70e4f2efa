// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <string_view>

namespace toile {

/// Writes a whole file so that whoever reads it, and whoever comes after a power cut, finds the old content or the new
/// one, never a part: a neighbour file is written, flushed to the disk and renamed. A symbolic link keeps pointing at
/// its target; an existing file keeps its permissions, and one that may not be written, or that nobody may write, is
/// not replaced.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// Whether a file could be written there now, asked before long work: the neighbour is made, and taken away again.
[[nodiscard]] Result<void> checkWritable(const std::filesystem::path& path);

} // namespace toile
