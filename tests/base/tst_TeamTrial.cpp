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

constexpr int turns = 10, fewTurns = 4, period = 128; // steps

} // namespace

class tst_TeamTrial : public QObject {
    Q_OBJECT
private slots:
    void bothWaysAreTriedFirst();
    void theFasterWayGoesOn();
    void whatIsClearIsTriedShortly();
    void aTeamThatBringsLittleRests();
    void slowStepsInTwoPairsDecideNothing();
    void whatLessensWithTimeDecidesNothing();
    void whatHasChangedIsNoticed();
};

void tst_TeamTrial::bothWaysAreTriedFirst() {
    TeamTrial trial;
    for (const bool shares : {true, false, false, true, true, false, false, true, true, false}) {
        QCOMPARE(trial.shares(), shares);
        trial.took(1);
    }
}

void tst_TeamTrial::theFasterWayGoesOn() {
    TeamTrial trial;
    QCOMPARE(sharedOf(trial, period, 0.85, 1), period - turns / 2);
    TeamTrial other;
    QCOMPARE(sharedOf(other, period, 1.1, 1), turns / 2);
}

/// Two steps alone where each costs half as much again; that sharing is dear is not taken for clear by two pairs.
void tst_TeamTrial::whatIsClearIsTriedShortly() {
    TeamTrial trial;
    QCOMPARE(sharedOf(trial, period, 0.7, 1), period - fewTurns / 2);
    TeamTrial dear;
    QCOMPARE(sharedOf(dear, fewTurns, 5, 1), fewTurns / 2);
    QCOMPARE(sharedOf(dear, turns - fewTurns, 0.9, 1), (turns - fewTurns) / 2);
    QVERIFY(dear.shares());
}

void tst_TeamTrial::aTeamThatBringsLittleRests() {
    TeamTrial trial;
    QCOMPARE(sharedOf(trial, period, 0.97, 1), turns / 2);
}

/// Of 5 pairs.
void tst_TeamTrial::slowStepsInTwoPairsDecideNothing() {
    for (const double shared : {0.85, 1.1}) {
        TeamTrial trial;
        for (int step = 0; step < turns; ++step) {
            const bool isSlow = step == 1 || step == 4 || step == 5;
            trial.took((isSlow ? 10 : 1) * (trial.shares() ? shared : 1));
        }
        QCOMPARE(trial.shares(), shared < 1);
    }
}

void tst_TeamTrial::whatLessensWithTimeDecidesNothing() {
    for (const double shared : {0.85, 1.05}) {
        TeamTrial trial;
        double seconds = 1;
        for (int step = 0; step < turns; ++step, seconds *= 0.92) trial.took(seconds * (trial.shares() ? shared : 1));
        QCOMPARE(trial.shares(), shared < 1);
    }
}

void tst_TeamTrial::whatHasChangedIsNoticed() {
    TeamTrial trial;
    (void)sharedOf(trial, period, 0.85, 1);
    QCOMPARE(sharedOf(trial, period, 1.1, 1), turns / 2);
    QCOMPARE(sharedOf(trial, period, 0.85, 1), period - turns / 2);
}

TOILE_TEST(tst_TeamTrial)
#include "tst_TeamTrial.moc"
