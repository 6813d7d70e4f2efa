// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Front.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>

using namespace toile;
using study::CostError;

class tst_Front : public QObject {
    Q_OBJECT
private slots:
    void onTheFrontIsWhatNoOtherBeatsInBoth();
    void ofEqualPointsTheFirstIsOnTheFront();
    void theOrderIsTheSlope();
    void betweenPointsTheCostIsReadAlongTheFront();
};

void tst_Front::onTheFrontIsWhatNoOtherBeatsInBoth() {
    const std::vector<CostError> points{{3, 1}, {1, 4}, {2, 5}, {2, 2}, {4, 1}};
    QCOMPARE(study::paretoFront(points), (std::vector<int>{1, 3, 0}));
    QVERIFY(study::paretoFront({}).empty());
}

void tst_Front::ofEqualPointsTheFirstIsOnTheFront() {
    const std::vector<CostError> points{{1, 1}, {1, 1}, {1, 2}};
    QCOMPARE(study::paretoFront(points), (std::vector<int>{0}));
}

void tst_Front::theOrderIsTheSlope() {
    const std::vector<double> steps{0.1, 0.05, 0.025};
    std::vector<double> errors;
    for (const double h : steps) errors.push_back(7 * h * h * h);
    QVERIFY(std::abs(study::observedOrder(steps, errors) - 3) < 1e-12);
    QVERIFY(std::isnan(study::observedOrder({}, {})));
}

void tst_Front::betweenPointsTheCostIsReadAlongTheFront() {
    const std::vector<CostError> points{{1, 1}, {10, 0.01}, {5, 3}}; // error = cost⁻²
    QVERIFY(std::abs(study::costOf(0.1, points) - std::sqrt(10)) < 1e-12);
    QCOMPARE(study::costOf(2, points), 1.0);
    QVERIFY(std::isnan(study::costOf(0.001, points)));
}

TOILE_TEST(tst_Front)
#include "tst_Front.moc"
