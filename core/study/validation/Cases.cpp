// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/validation/Cases.h"

namespace toile::study::validation {

std::vector<Case> allCases() {
    std::vector<Case> all;
    for (const auto& theme : {elasticityCases, staticCases, bucklingCases, oscillationCases, integratorCases,
                              contactCases, sewingCases, wrappingCases, impactCases, loopCases, drapeCases, skirtCases})
        for (const Case& one : theme()) all.push_back(one);
    return all;
}

std::vector<Row> rowsOf(const Case& one) {
    Findings found{std::string(one.number)};
    one.run(found);
    if (found.rows().empty()) found.stop("The case has measured nothing.");
    return found.rows();
}

std::vector<NotOffered> casesNotOffered() {
    return {
        {"V10", "stick–slip of a cantilever pushed on to a plane",
         "The boundaries of its regimes stand in Romero 2021, which was not at hand."},
        {"V14", "bend–twist of a naturally curved ribbon", "Cloth that is curved at rest is not offered."},
    };
}

} // namespace toile::study::validation
