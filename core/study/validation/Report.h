// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/study/Circumstances.h"
#include "core/study/validation/Cases.h"

namespace toile::study::validation {

/// A case with what it found.
struct Outcome {
    Case which;
    std::vector<Row> rows;
};

[[nodiscard]] bool allPass(const std::vector<Outcome>& outcomes);

/// "241 of 242 rows pass; V24 fails; V10 and V14 are not offered."
[[nodiscard]] std::string summaryOf(const std::vector<Outcome>& outcomes, const std::vector<NotOffered>& notOffered);

/// The table in Markdown: every row with its verdict, and what is not offered with the reason.
[[nodiscard]] std::string validationText(const std::vector<Outcome>& outcomes,
                                         const std::vector<NotOffered>& notOffered, const Circumstances& circumstances);

/// One record a row, and one for each case that is not offered.
[[nodiscard]] std::vector<Json> recordsOf(const std::vector<Outcome>& outcomes,
                                          const std::vector<NotOffered>& notOffered,
                                          const Circumstances& circumstances);

} // namespace toile::study::validation
