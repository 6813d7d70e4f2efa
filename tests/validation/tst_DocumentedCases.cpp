// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/validation/ThemeTest.h"

using namespace toile::study::validation;

/// docs/validation.md lists every case once, and adds up what it lists. What it says of each case is checked where the
/// case is run.
class tst_DocumentedCases : public QObject {
    Q_OBJECT
private slots:
    void everyCaseIsThere();
    void sumsAreThoseOfTheTable();
};

void tst_DocumentedCases::everyCaseIsThere() {
    QStringList offered, missing, said, saidMissing;
    for (const Case& one : allCases()) offered << QString("%1 %2").arg(one.number.data(), one.title.data());
    for (const NotOffered& one : casesNotOffered()) missing << one.number.data();
    for (const QStringList& row : documentedCases()) {
        if (row[6] == "not offered") saidMissing << row[0];
        else said << row[0] + " " + row[1];
    }
    offered.removeDuplicates(); // rows of one case may come from several
    offered.sort();
    said.sort();
    QCOMPARE(said, offered);
    missing.sort();
    saidMissing.sort();
    QCOMPARE(saidMissing, missing);
}

void tst_DocumentedCases::sumsAreThoseOfTheTable() {
    int rows = 0, failed = 0;
    QStringList failing;
    for (const QStringList& row : documentedCases()) {
        rows += row[2].toInt();
        if (!row[6].startsWith("FAIL: ")) continue;
        failed += row[6].section(' ', 1, 1).toInt();
        if (!failing.contains(row[0])) failing << row[0];
    }
    const QString text = toile::page("validation.md");
    const QString sums = QString("**%1 of %2 rows pass. Failing: ").arg(rows - failed).arg(rows);
    QVERIFY2(text.contains(sums), qPrintable(sums));
    QStringList saidFailing = text.section(sums, 1).section('.', 0, 0).split(", ");
    failing.sort();
    saidFailing.sort();
    QCOMPARE(saidFailing, failing);
}

TOILE_TEST(tst_DocumentedCases)
#include "tst_DocumentedCases.moc"
