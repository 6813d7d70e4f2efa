// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/validation/Cases.h"
#include "tests/base/Pages.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <cstdio>

/// A test per theme of core/study/validation: every case is a slot's data row, every row of a case is checked
/// and held against what docs/validation.md says of the case.
namespace toile::study::validation {

/// What the page says of a case: number, title, count of rows, "worst row: expected", measured, tolerance, verdict.
inline QList<QStringList> documentedCases() {
    return tableIn(page("validation.md"), "case | | rows");
}

inline bool areOne(const Case& a, const Case& b) {
    return a.number == b.number && a.title == b.title;
}

/// One row for all cases of a number and title.
inline void addRowsFor(const std::vector<Case>& cases) {
    QTest::addColumn<std::size_t>("index");
    for (auto one = cases.begin(); one != cases.end(); ++one)
        if (std::none_of(cases.begin(), one, [&](const Case& before) { return areOne(before, *one); }))
            QTest::addRow("%s %s", one->number.data(), one->title.data())
                << static_cast<std::size_t>(one - cases.begin());
}

/// Empty when the page's row says what was found.
inline QString differenceFrom(const QStringList& written, const std::vector<Row>& rows) {
    if (static_cast<int>(rows.size()) != written[2].toInt()) return QString("%1 rows").arg(rows.size());
    const auto failed = rows.size() - static_cast<std::size_t>(std::ranges::count_if(rows, &Row::passes));
    const QString verdict = failed ? QString("FAIL: %1 of %2").arg(failed).arg(rows.size()) : "PASS";
    if (written[6] != verdict) return verdict;
    const qsizetype colon = written[3].lastIndexOf(": ");
    const QString what = written[3].left(colon).replace("\\|", "|"), expected = written[3].mid(colon + 2);
    // What is bounded is often rounding, which processors do differently. Rows "the same" differ in what is expected.
    const bool isBound = expected.startsWith("≤");
    const auto worst = std::ranges::find_if(rows, [&](const Row& row) {
        return QString::fromStdString(row.what) == what && row.isBound == isBound &&
               (isBound || std::abs(row.expected - expected.toDouble()) <= 1e-5 * std::abs(row.expected));
    });
    if (worst == rows.end()) return "no row \"" + what + "\" that expects " + expected;
    const double allowed =
        std::max(0.1 * worst->tolerance * std::abs(worst->expected), 1e-5 * std::abs(worst->measured));
    if (!isBound && std::abs(worst->measured - written[4].toDouble()) > allowed)
        return QString::number(worst->measured);
    return {};
}

/// Prints the lines of the table. A case with an open problem is expected to fail, so that its repair is seen.
inline void checkRow(const std::vector<Case>& cases) {
    QFETCH(std::size_t, index);
    const Case& first = cases[index];
    std::vector<Row> rows;
    for (const Case& one : cases) {
        if (!areOne(one, first)) continue;
        bool pass = true;
        for (Row& row : rowsOf(one)) {
            std::puts(lineOf(row).c_str());
            pass &= row.passes();
            rows.push_back(std::move(row));
        }
        std::fflush(stdout);
        if (!one.openProblem.empty()) QEXPECT_FAIL("", one.openProblem.data(), Continue);
        QVERIFY(pass);
    }
    int told = 0;
    for (const QStringList& written : documentedCases()) {
        if (written[0] != first.number.data() || written[1] != first.title.data()) continue;
        QCOMPARE(differenceFrom(written, rows), QString());
        ++told;
    }
    QCOMPARE(told, 1);
}

} // namespace toile::study::validation
