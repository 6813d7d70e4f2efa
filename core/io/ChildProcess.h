// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <cstddef>
#include <functional>
#include <string>

namespace toile::io {

struct ChildLimits {
    double seconds = 60;                       ///< of the clock; a hanging library is stopped then [s]
    std::size_t memory = std::size_t{4} << 30; ///< beyond what the program has already [bytes]
    std::size_t answer = std::size_t{2} << 30; ///< longest answer that is taken [bytes]
};

/// Runs work in a child process and returns what it returned. Whatever the work does – crash, abort, never end, take
/// all memory – becomes an Error here: work on untrusted data is done by libraries that do these things.
/// The child writes no file and says nothing on the terminal.
[[nodiscard]] Result<std::string> runInChild(const std::function<std::string()>& work, const ChildLimits& limits = {});

} // namespace toile::io
