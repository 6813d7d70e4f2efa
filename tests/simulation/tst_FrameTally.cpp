// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/FrameTally.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

class tst_FrameTally : public QObject {
    Q_OBJECT
private slots:
    void framesAreCountedByWhatTheyShow();
    void whatIsNotSeenHasNoTime();
};

void tst_FrameTally::framesAreCountedByWhatTheyShow() {
    FrameTally tally;
    tally.add(0, {.body = 4});
    tally.add(0.25, {.body = 6, .self = 1, .atOpenSeams = 3});
    tally.add(0.5, {.body = 2, .atOpenSeams = 5});
    tally.add(0.75, {});
    QCOMPARE(tally.frames, 4);
    QCOMPARE(tally.withBody.frames, 3);
    QCOMPARE(tally.withBody.most, 6);
    QCOMPARE(*tally.withBody.last, 0.5);
    QCOMPARE(tally.withItself.frames, 1);
    QCOMPARE(*tally.withItself.last, 0.25);
    QCOMPARE(describe(tally), "4 frames: 3 with intersections with the body, up to 6, the last at 0.50 s; "
                              "1 with intersections of the cloth with itself, up to 1, the last at 0.25 s; "
                              "2 with intersections beside seams that close, up to 5, the last at 0.50 s");
}

void tst_FrameTally::whatIsNotSeenHasNoTime() {
    FrameTally tally;
    tally.add(0, {});
    QCOMPARE(describe(tally), "1 frames: none with intersections with the body; none with intersections of the cloth "
                              "with itself; none with intersections beside seams that close");
    const Json json = toJson(tally);
    QVERIFY(json.find("withBody")->find("last")->isNull());
    QCOMPARE(*json.find("count")->asNumber(), 1.0);
}

TOILE_TEST(tst_FrameTally)
#include "tst_FrameTally.moc"
