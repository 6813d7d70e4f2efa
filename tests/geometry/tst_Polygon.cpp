// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Polygon.h"
#include "tests/Suite.h"

#include <QTest>

using namespace toile::geometry;

class tst_Polygon : public QObject {
    Q_OBJECT
private slots:
    void areaIsPositiveCounterClockwise();
    void areaKeepsItsDigitsFarFromTheOrigin();
    void windingCountsTurns();
    void distanceIsToTheNearestBorder();
    void theBoxHoldsAllPoints();
};

namespace {
const Polygon square{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
}

void tst_Polygon::areaIsPositiveCounterClockwise() {
    QCOMPARE(signedArea(square), 2.0);
    QCOMPARE(signedArea(Polygon(square.rbegin(), square.rend())), -2.0);
    QCOMPARE(signedArea(Polygon{}), 0.0);
}

void tst_Polygon::areaKeepsItsDigitsFarFromTheOrigin() {
    Polygon far = square;
    for (Vec2& p : far) p += {1e6, -1e6};
    QCOMPARE(signedArea(far), 2.0);
}

void tst_Polygon::windingCountsTurns() {
    QCOMPARE(windingNumber(square, {1, 0.5}), 1);
    QCOMPARE(windingNumber(square, {3, 0.5}), 0);
    QCOMPARE(windingNumber(Polygon(square.rbegin(), square.rend()), {1, 0.5}), -1);
    Polygon twice = square;
    twice.insert(twice.end(), square.begin(), square.end());
    QCOMPARE(windingNumber(twice, {1, 0.5}), 2);
}

void tst_Polygon::distanceIsToTheNearestBorder() {
    QCOMPARE(distanceToBorder(square, {1, 0.4}), 0.4);
    QCOMPARE(distanceToBorder(square, {3, 0.5}), 1.0);
    QCOMPARE(distanceToBorder(square, {5, 5}), 5.0); // 3–4–5 to the corner (2, 1)
    QCOMPARE(closestOnSegment({1, 1}, {1, 1}, {4, 5}), (Vec2{1, 1}));
}

void tst_Polygon::theBoxHoldsAllPoints() {
    const Box2 box = boundsOf(square);
    QCOMPARE(box.low, (Vec2{0, 0}));
    QCOMPARE(box.high, (Vec2{2, 1}));
}

TOILE_TEST(tst_Polygon)
#include "tst_Polygon.moc"
