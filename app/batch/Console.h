// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace toile::batch {

/// Exit statuses that scripts rely on.
enum ExitStatus {
    done = 0,
    inputWrong = 1, ///< the input is wrong or the work impossible; a sentence on stderr says so
    usageWrong = 2,
    goalMissed = 3, ///< it ran, but a seam stayed open or the cloth did not come to rest
};

/// Text of a file or of an option as it can stand in one line of a terminal: line ends, escapes and other control
/// characters as in JSON.
[[nodiscard]] std::string oneLine(std::string_view text);

/// Prints "FILE: place: sentence" on stderr.
void printError(const Error& error);
/// Prints "place: sentence" on stderr, a line for each.
void printWarnings(const std::vector<Warning>& warnings);

/// A bar that rewrites its line on a terminal, one plain line a second elsewhere.
class ProgressBar {
public:
    explicit ProgressBar(bool quiet);
    ~ProgressBar(); ///< ends the line

    [[nodiscard]] Progress progress();
    /// Of one part of a work of so many that take alike: `done` of them lie behind it.
    [[nodiscard]] Progress progress(std::size_t done, std::size_t parts);

private:
    void show(double fraction, const std::string& what);

    bool quiet_, terminal_, shown_ = false;
    std::chrono::steady_clock::time_point start_, last_;
};

} // namespace toile::batch
