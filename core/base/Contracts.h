// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <source_location>

namespace toile {

/// Stops the program when a condition that our own code must guarantee does not hold; says where.
/// For mistakes of users and files see Result.h.
void expects(bool condition, const char* what = "", std::source_location where = std::source_location::current());

namespace detail {
[[noreturn]] void contractBroken(const char* what, const std::source_location& where);
}

inline void expects(bool condition, const char* what, std::source_location where) {
    if (!condition) [[unlikely]]
        detail::contractBroken(what, where);
}

} // namespace toile
