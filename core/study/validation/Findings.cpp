// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/validation/Findings.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace toile::study::validation {

bool Row::passes() const { // what is not a number is neither within nor below anything
    if (!stopped.empty()) return false;
    return isBound ? measured <= expected : std::abs(measured - expected) <= tolerance * std::abs(expected);
}

std::string lineOf(const Row& row) {
    const char* verdict = row.passes() ? "PASS" : "FAIL";
    if (!row.stopped.empty()) return fmt::format("{:<5} {:<58} {} {}", row.number, row.what, row.stopped, verdict);
    if (row.isBound)
        return fmt::format("{:<5} {:<58} at most  {:<11.3g} measured {:<11.3g} {:>17} {}", row.number, row.what,
                           row.expected, row.measured, "", verdict);
    return fmt::format("{:<5} {:<58} expected {:<11.6g} measured {:<11.6g} tolerance {:<8.2g} {}", row.number, row.what,
                       row.expected, row.measured, row.tolerance, verdict);
}

void Findings::within(std::string what, double expected, double measured, double tolerance) {
    if (!stopped_) rows_.push_back({number_, std::move(what), false, expected, measured, tolerance, {}});
}

void Findings::atMost(std::string what, double bound, double measured) {
    if (!stopped_) rows_.push_back({number_, std::move(what), true, bound, measured, 0, {}});
}

void Findings::stop(const std::string& why) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    if (!stopped_) rows_.push_back({number_, "stopped", false, nothing, nothing, 0, why});
    stopped_ = true;
}

} // namespace toile::study::validation
