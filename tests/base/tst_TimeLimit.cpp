// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/TimeLimit.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using namespace std::chrono_literals;

namespace {

const Error cancelled{ErrorCode::cancelled, "The run was stopped.", {}};
const auto now = [] { return std::chrono::steady_clock::now(); };

} // namespace

class tst_TimeLimit : public QObject {
    Q_OBJECT
private slots:
    void whatIsOverStopsTheWorkAtOnce();
    void othersStopItBefore();
    void theClockStopsIt();
    void withoutADeadlineNothingDoes();
};

void tst_TimeLimit::whatIsOverStopsTheWorkAtOnce() {
    const TimeLimit limit(now() - 1s, {});
    QVERIFY(limit.token().stop_requested());
    QVERIFY(limit.ended(cancelled));
    QVERIFY(!limit.ended({ErrorCode::notConverged, "", {}}));
}

void tst_TimeLimit::othersStopItBefore() {
    std::stop_source others;
    const TimeLimit late(now() + 1h, others.get_token()), over(now() - 1s, others.get_token());
    QVERIFY(!late.token().stop_requested());
    others.request_stop();
    QVERIFY(late.token().stop_requested());
    QVERIFY(!late.ended(cancelled));
    QVERIFY(!over.ended(cancelled)); // who stopped it wants no report
}

void tst_TimeLimit::theClockStopsIt() {
    const TimeLimit limit(now() + 1ms, {});
    while (!limit.token().stop_requested()) std::this_thread::yield();
    QVERIFY(limit.isOver());
}

void tst_TimeLimit::withoutADeadlineNothingDoes() {
    const TimeLimit limit(std::nullopt, {});
    QVERIFY(!limit.token().stop_requested());
    QVERIFY(!limit.isOver());
}

TOILE_TEST(tst_TimeLimit)
#include "tst_TimeLimit.moc"
