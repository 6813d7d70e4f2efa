// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Team.h"

#include <QtTest>
#include <numeric>
#include <stdexcept>
#include <vector>

using namespace toile;

class tst_Team : public QObject {
    Q_OBJECT
private slots:
    void eachIsDoneOnce() {
        std::vector<int> times(1000, 0);
        Team().run(1000, [&](int i) { ++times[static_cast<std::size_t>(i)]; });
        QCOMPARE(times, std::vector<int>(1000, 1));
    }

    void noneIsNothing() {
        Team().run(0, [](int) { QFAIL("nothing was to be done"); });
    }

    void itWorksAgainAndAgain() {
        Team team;
        for (int round = 0; round < 2000; ++round) {
            std::vector<int> times(static_cast<std::size_t>(round % 5), 0);
            team.run(round % 5, [&](int i) { ++times[static_cast<std::size_t>(i)]; });
            QCOMPARE(times, std::vector<int>(times.size(), 1));
        }
    }

    void anExceptionArrivesAfterAllOthersAreDone() {
        std::vector<int> done(100, 0);
        QVERIFY_EXCEPTION_THROWN(Team().run(100,
                                            [&](int i) {
                                                if (i == 3) throw std::runtime_error("three");
                                                done[static_cast<std::size_t>(i)] = 1;
                                            }),
                                 std::runtime_error);
        QCOMPARE(std::accumulate(done.begin(), done.end(), 0), 99);
    }
};

QTEST_APPLESS_MAIN(tst_Team)
#include "tst_Team.moc"
