// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/TeamTrial.h"
#include "tests/Suite.h"

#include <QTest>

using toile::TeamTrial;

namespace {

/// How many of so many steps are shared out, which take so long with a team and without.
int sharedOf(TeamTrial& trial, int steps, double shared, double alone) {
    int count = 0;
    for (int step = 0; step < steps; ++step) {
        const bool shares = trial.shares();
        count += shares;
        trial.took(shares ? shared : alone);
    }
    return count;
}

constexpr int turns = 4, period = 32; // steps

} // namespace

class tst_TeamTrial : public QObject {
    Q_OBJECT
private slots:
    void bothWaysAreTriedFirst();
    void theFasterWayGoesOn();
    void aTeamThatBringsLittleRests();
    void oneSlowStepDecidesNothing();
    void whatHasChangedIsNoticed();
};

void tst_TeamTrial::bothWaysAreTriedFirst() {
    TeamTrial trial;
    for (const bool shares : {true, true, false, false}) {
        QCOMPARE(trial.shares(), shares);
        trial.took(1);
    }
}

void tst_TeamTrial::theFasterWayGoesOn() {
    TeamTrial trial;
    QCOMPARE(sharedOf(trial, period, 0.7, 1), period - turns / 2);
    TeamTrial other;
    QCOMPARE(sharedOf(other, period, 1.1, 1), turns / 2);
}

void tst_TeamTrial::aTeamThatBringsLittleRests() {
    TeamTrial trial;
    QCOMPARE(sharedOf(trial, period, 0.97, 1), turns / 2);
}

void tst_TeamTrial::oneSlowStepDecidesNothing() {
    TeamTrial trial;
    for (const double seconds : {10.0, 0.7, 1.0, 1.0}) trial.took(seconds);
    QVERIFY(trial.shares());
}

void tst_TeamTrial::whatHasChangedIsNoticed() {
    TeamTrial trial;
    (void)sharedOf(trial, period, 0.7, 1);
    QCOMPARE(sharedOf(trial, period, 1.1, 1), turns / 2);
    QCOMPARE(sharedOf(trial, period, 0.7, 1), period - turns / 2);
}

TOILE_TEST(tst_TeamTrial)
#include "tst_TeamTrial.moc"
