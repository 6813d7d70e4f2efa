// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace toile::batch {

/// The cases of a study that were asked for by number, and those of them that cannot be run.
template <class Case, class Other>
struct ChosenCases {
    std::vector<Case> cases;
    std::vector<Other> others;
};

/// Those that are named; all, where none is. kind: "validation", for the message.
template <class Case, class Other>
Result<ChosenCases<Case, Other>> chosenOf(std::vector<Case> cases, std::vector<Other> others,
                                          const std::vector<std::string>& numbers, std::string_view kind) {
    const auto isAmong = [](const auto& all, const std::string& number) {
        return std::ranges::any_of(all, [&](const auto& one) { return one.number == number; });
    };
    for (const std::string& number : numbers)
        if (!isAmong(cases, number) && !isAmong(others, number))
            return fail(ErrorCode::notFound, fmt::format("There is no {} case \"{}\".", kind, number));
    const auto isNotNamed = [&](const auto& one) {
        return !numbers.empty() && std::ranges::find(numbers, one.number) == numbers.end();
    };
    std::erase_if(cases, isNotNamed);
    std::erase_if(others, isNotNamed);
    return ChosenCases<Case, Other>{std::move(cases), std::move(others)};
}

} // namespace toile::batch
