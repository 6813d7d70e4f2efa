// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/PatternCheck.h"

#include <string>
#include <vector>

namespace toile::tests {

/// The sentences of what a pattern must not have; warnings are left out.
inline std::vector<std::string> errorsOf(const pattern::Pattern& pattern) {
    std::vector<std::string> texts;
    for (const pattern::Problem& problem : checkPattern(pattern))
        if (problem.isError) texts.push_back(toString(problem));
    return texts;
}

} // namespace toile::tests
