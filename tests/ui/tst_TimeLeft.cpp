// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "ui/accuracy/TimeLeft.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

/// How long a study still takes.
class tst_TimeLeft : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void nothingIsGuessedBeforeTheFirstGoIsOver();
    void equalGoesTakeEqualTimes();
    void theSecondRepetitionTakesAsLongAsTheFirst();
};

namespace {

/// Two references and two setups, twice.
study::GarmentPlan plan() {
    study::GarmentPlan plan;
    plan.referenceFactor = 1;
    plan.referenceRuns = 2;
    plan.repetitions = 2;
    plan.setups = {{true, 1, dynamics::Method::xpbd}, {false, 1, dynamics::Method::xpbd}};
    return plan;
}

} // namespace

void tst_TimeLeft::nothingIsGuessedBeforeTheFirstGoIsOver() {
    TimeLeft left(plan());
    QCOMPARE(left.goes(), 6);
    QVERIFY(!left.at(0));
    left.begin(0, 0);
    QVERIFY(!left.at(5));
}

void tst_TimeLeft::equalGoesTakeEqualTimes() {
    TimeLeft left(plan());
    left.begin(0, 0);
    left.begin(1, 10);
    QCOMPARE(*left.at(10), 50.0);
    QCOMPARE(*left.at(14), 46.0);
    QCOMPARE(*left.at(30), 40.0); // it takes longer than was thought
}

void tst_TimeLeft::theSecondRepetitionTakesAsLongAsTheFirst() {
    TimeLeft left(plan());
    for (const auto& [go, at] : {std::pair(0, 0.0), {1, 10.0}, {2, 20.0}, {3, 24.0}, {4, 26.0}}) left.begin(go, at);
    QCOMPARE(*left.at(26), 6.0);
}

TOILE_TEST(tst_TimeLeft, QCoreApplication)
#include "tst_TimeLeft.moc"
