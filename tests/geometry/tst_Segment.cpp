// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Segment.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile;
using geometry::distanceToSegment;

class tst_Segment : public QObject {
    Q_OBJECT
private slots:
    void theNearestPlaceCounts() {
        const Vec3 a{0, 0, 0}, b{4, 0, 0};
        QCOMPARE(distanceToSegment({1, 0, 3}, a, b), 3.0);  // beside it
        QCOMPARE(distanceToSegment({7, 4, 0}, a, b), 5.0);  // beyond its end
        QCOMPARE(distanceToSegment({-3, 0, 4}, a, b), 5.0); // before its start
        QCOMPARE(distanceToSegment({2, 0, 0}, a, b), 0.0);
        QCOMPARE(distanceToSegment({3, 4, 0}, a, a), 5.0);
    }
};

TOILE_TEST(tst_Segment)
#include "tst_Segment.moc"
