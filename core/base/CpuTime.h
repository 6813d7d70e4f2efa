// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ctime>

namespace toile {

/// Processor time of this process so far, all threads together [s].
[[nodiscard]] inline double processSeconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

} // namespace toile
