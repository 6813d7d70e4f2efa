// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/cloth/Fixtures.h"

#include <QTest>
#include <cmath>
#include <cstdio>
#include <string>

namespace toile::validation {

/// Prints one line of the table of cases and says whether it passed. The tolerance is relative to `expected`.
inline bool caseWithin(const char* number, const std::string& what, double expected, double measured,
                       double tolerance) {
    const bool pass = std::abs(measured - expected) <= tolerance * std::abs(expected);
    std::printf("%-5s %-58s expected %-11.6g measured %-11.6g tolerance %-8.2g %s\n", number, what.c_str(), expected,
                measured, tolerance, pass ? "PASS" : "FAIL");
    std::fflush(stdout);
    return pass;
}

/// The same for a quantity that should be 0, or below a bound.
inline bool caseBelow(const char* number, const std::string& what, double bound, double measured) {
    const bool pass = measured <= bound;
    std::printf("%-5s %-58s at most  %-11.3g measured %-11.3g %17s %s\n", number, what.c_str(), bound, measured, "",
                pass ? "PASS" : "FAIL");
    std::fflush(stdout);
    return pass;
}

inline cloth::ClothModel modelOf(const cloth::Patch& patch, const material::Fabric& fabric,
                                 cloth::CellForm form = cloth::CellForm::automatic) {
    cloth::ClothModel model;
    auto report = cloth::appendPatch(model, patch, fabric, {form});
    if (!report) qFatal("%s", toString(report.error()).c_str());
    return model;
}

} // namespace toile::validation
