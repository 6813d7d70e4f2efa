// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/study/Circumstances.h"

#include <filesystem>
#include <string>
#include <vector>

namespace toile::batch {

/// Where a study leaves its report: made with all folders above it.
[[nodiscard]] Result<void> madeFolder(const std::string& folder);

/// This build and this machine; takes a moment, to calibrate its time.
[[nodiscard]] study::Circumstances circumstancesOf(std::string command);

/// report.md, the same for the browser as report.html, and results.jsonl with a record a line.
[[nodiscard]] Result<void> writeReport(const std::filesystem::path& folder, const std::string& text,
                                       const std::vector<Json>& records);

/// The records of a report: of its folder, or of its results.jsonl.
[[nodiscard]] Result<std::vector<Json>> recordsIn(const std::filesystem::path& report);

/// Runs gnuplot on a script in its folder. False where there is none, or it fails.
[[nodiscard]] bool drawn(const std::filesystem::path& script);

/// To be said where it was not.
inline constexpr const char* withoutPictures = ", without pictures: gnuplot (Debian's gnuplot-nox) did not run";

} // namespace toile::batch
