// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/validation/Cases.h"

#include <QTest>
#include <cstdio>

/// A test program per theme of core/study/validation: every case is a slot's data row, every row of a case is checked.
namespace toile::study::validation {

inline void addRowsFor(const std::vector<Case>& cases) {
    QTest::addColumn<std::size_t>("index");
    for (std::size_t i = 0; i < cases.size(); ++i)
        QTest::addRow("%s %s %d", cases[i].number.data(), cases[i].title.data(), static_cast<int>(i)) << i;
}

/// Prints the lines of the table. A case with an open problem is expected to fail, so that its repair is seen.
inline void checkRow(const std::vector<Case>& cases) {
    QFETCH(std::size_t, index);
    const Case& one = cases[index];
    bool pass = true;
    for (const Row& row : rowsOf(one)) {
        std::puts(lineOf(row).c_str());
        pass &= row.passes();
    }
    std::fflush(stdout);
    if (!one.openProblem.empty()) QEXPECT_FAIL("", one.openProblem.data(), Continue);
    QVERIFY(pass);
}

} // namespace toile::study::validation
