// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace toile {

/// A number that is not negative, as what the standard's containers count with.
[[nodiscard]] constexpr std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

} // namespace toile
