// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/validation/Findings.h"

#include <string_view>

namespace toile::study::validation {

/// Something whose answer is known in closed form or from the literature, and what of ours is held against it. A number
/// may have several cases.
struct Case {
    std::string_view number; ///< "V5", as in the specification of validation
    std::string_view theme;  ///< "statics": a file of cases, and a test program
    std::string_view title;
    void (*run)(Findings&) = nullptr;
    std::string_view openProblem = {}; ///< why it fails today, where that is known; it fails all the same
};

/// Of all themes, by theme.
[[nodiscard]] std::vector<Case> allCases();

/// The rows of a case, of which there is at least one.
[[nodiscard]] std::vector<Row> rowsOf(const Case& one);

/// A case that cannot be run, and what it would take.
struct NotOffered {
    std::string_view number, title, reason;
};
[[nodiscard]] std::vector<NotOffered> casesNotOffered();

/// The themes, one per file of this folder.
[[nodiscard]] std::vector<Case> elasticityCases();
[[nodiscard]] std::vector<Case> staticCases();
[[nodiscard]] std::vector<Case> bucklingCases();
[[nodiscard]] std::vector<Case> oscillationCases();
[[nodiscard]] std::vector<Case> integratorCases();
[[nodiscard]] std::vector<Case> contactCases();
[[nodiscard]] std::vector<Case> sewingCases();
[[nodiscard]] std::vector<Case> wrappingCases();
[[nodiscard]] std::vector<Case> impactCases();
[[nodiscard]] std::vector<Case> loopCases();
[[nodiscard]] std::vector<Case> drapeCases();
[[nodiscard]] std::vector<Case> skirtCases();

} // namespace toile::study::validation
