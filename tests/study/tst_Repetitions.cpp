// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Repetitions.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using namespace toile::study;

class tst_Repetitions : public QObject {
    Q_OBJECT
private slots:
    void leastAndMedianOfRuns();
    void runsOfBusyMachinesAreNoisy();
    void runsTakeTurnsUntilOneFails();
};

void tst_Repetitions::leastAndMedianOfRuns() {
    const RunTime time = runTimeOf({3, 1, 2});
    QCOMPARE(time.least, 1.0);
    QCOMPARE(time.median, 2.0);
    QCOMPARE(runTimeOf({1, 2}).median, 1.5);
    QCOMPARE(runTimeOf({}).least, 0.0);
}

void tst_Repetitions::runsOfBusyMachinesAreNoisy() {
    QVERIFY(!runTimeOf({1, 1.29, 5}).noisy);
    QVERIFY(runTimeOf({1, 1.31, 1.32}).noisy);
    QVERIFY(!runTimeOf({0.001, 0.002, 0.003}).noisy); // too short to tell
}

void tst_Repetitions::runsTakeTurnsUntilOneFails() {
    std::string turns;
    const auto note = [&](std::size_t i, int) -> Result<void> {
        turns += static_cast<char>('A' + i);
        return {};
    };
    QVERIFY(inTurns(3, 2, note));
    QCOMPARE(turns, std::string("ABCABC"));
    turns.clear();
    const auto failing = [&](std::size_t i, int repetition) -> Result<void> {
        if (i == 1 && repetition == 1) return fail(ErrorCode::cancelled, "It was stopped.");
        return note(i, repetition);
    };
    QVERIFY(!inTurns(3, 2, failing));
    QCOMPARE(turns, std::string("ABCA"));
}

TOILE_TEST(tst_Repetitions)
#include "tst_Repetitions.moc"
