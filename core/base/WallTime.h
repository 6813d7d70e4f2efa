// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>

namespace toile {

/// By the clock on the wall [s].
[[nodiscard]] inline double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace toile
