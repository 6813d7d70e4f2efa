// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Team.h"
#include "tests/Suite.h"

#include <QTest>
#include <chrono>
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

    void helpersThatHaveJustBegunAreDismissedAsWell() {
        for (int round = 0; round < 2000; ++round) {
            std::vector<int> times(static_cast<std::size_t>(1 + round % 3), 0);
            Team(3).run(1 + round % 3, [&](int i) { ++times[static_cast<std::size_t>(i)]; });
            QCOMPARE(times, std::vector<int>(times.size(), 1));
        }
    }

    void callsThatFollowSlowlyAreHeardAsWell() {
        Team team(4);
        for (int round = 0; round < 20; ++round) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2)); // helpers sleep by now
            std::vector<int> times(50, 0);
            team.run(50, [&](int i) { ++times[static_cast<std::size_t>(i)]; });
            QCOMPARE(times, std::vector<int>(50, 1));
        }
    }

    void partsCoverAllOnce_data() {
        QTest::addColumn<int>("members");
        QTest::addColumn<int>("count");
        for (const int members : {1, 2, 5})
            for (const int count : {0, 1, 99, 200, 1003}) QTest::addRow("%d of %d", count, members) << members << count;
    }
    void partsCoverAllOnce() {
        QFETCH(int, members);
        QFETCH(int, count);
        Team team(members);
        QCOMPARE(team.members(), members);
        std::vector<int> times(static_cast<std::size_t>(count), 0);
        std::atomic<int> smallest = count;
        inParts(&team, count, 100, [&](int begin, int end) {
            if (end - begin < smallest) smallest = end - begin;
            for (int i = begin; i < end; ++i) ++times[static_cast<std::size_t>(i)];
        });
        QCOMPARE(times, std::vector<int>(static_cast<std::size_t>(count), 1));
        QVERIFY(smallest >= std::min(count, 100 / 4)); // a member takes four
    }

    void theLargestOfAllPartsIsFound() {
        Team team(3);
        for (const int largest : {0, 1, 499, 998, 999}) {
            const auto valueAt = [&](int i) { return i == largest ? 7.0 : 1.0 / (i + 1); };
            QCOMPARE(largestInParts(&team, 1000, 10,
                                    [&](int begin, int end) {
                                        double found = 0;
                                        for (int i = begin; i < end; ++i) found = std::max(found, valueAt(i));
                                        return found;
                                    }),
                     7.0);
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

TOILE_TEST(tst_Team)
#include "tst_Team.moc"
