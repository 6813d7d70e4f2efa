// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/study/Circumstances.h"

#include <filesystem>

namespace toile::batch {

/// Where a study leaves its report: made with all folders above it.
[[nodiscard]] Result<void> madeFolder(const std::string& folder);

/// This build and this machine; takes a moment, to calibrate its time.
[[nodiscard]] study::Circumstances circumstancesOf(std::string command);

/// Runs gnuplot on a script in its folder. False where there is none, or it fails.
[[nodiscard]] bool drawn(const std::filesystem::path& script);

/// To be said where it was not.
inline constexpr const char* withoutPictures = ", without pictures: gnuplot (Debian's gnuplot-nox) did not run";

} // namespace toile::batch
