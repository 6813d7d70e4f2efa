// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Curve.h"
#include "tests/Suite.h"

#include <QTest>
#include <numbers>

using namespace toile::geometry;

/// The laws hold for every kind of curve.
class tst_Curve : public QObject {
    Q_OBJECT
private slots:
    void aQuarterCircleHasItsLength();
    void lengthsFollowClosedForms();
    void splitPartsRunWhereTheWholeRan_data() { addCurves(); }
    void splitPartsRunWhereTheWholeRan();
    void lengthsOfPartsAddUp_data() { addCurves(); }
    void lengthsOfPartsAddUp();
    void reversedRunsBackwards_data() { addCurves(); }
    void reversedRunsBackwards();
    void twoMirrorsCancel_data() { addCurves(); }
    void twoMirrorsCancel();
    void aMirrorKeepsLengthsAndDistances_data() { addCurves(); }
    void aMirrorKeepsLengthsAndDistances();
    void flattenedStaysWithinItsError_data() { addCurves(); }
    void flattenedStaysWithinItsError();
    void tangentsAreDerivatives_data() { addCurves(); }
    void tangentsAreDerivatives();
    void arcLengthAndParameterAreInverse_data() { addCurves(); }
    void arcLengthAndParameterAreInverse();
    void aHandleOnItsEndPointStillHasATangent();
    void aCurveWithoutLengthHasItsFractions();
    void aStraightArcIsALine();
    void anEnormousCurveIsFlattenedInFiniteTime();

private:
    static void addCurves();
};

namespace {

constexpr double pi = std::numbers::pi;
const Curve quarter{{0.1, 0}, {0, 0.1}, ArcShape{std::tan(pi / 8)}};

Curve curveNumber(int n) {
    switch (n) {
    case 0: return {{0.1, -0.2}, {0.4, 0.3}, LineShape{}};
    case 1: return {{0, 0}, {0.3, 0.1}, CubicShape{{0.1, 0.2}, {0.2, -0.1}}};
    case 2: return {{0, 0}, {0.1, 0}, CubicShape{{0.2, 0.1}, {-0.1, 0.1}}}; // a loop
    case 3: return quarter;
    case 4: return {{0, 0}, {0.2, 0.05}, ArcShape{-0.3}};
    default: return {{0, 0}, {0.1, 0.1}, ArcShape{2.5}}; // more than a half circle
    }
}

double distanceToPolyline(const std::vector<Vec2>& points, Vec2 p) {
    double best = 1e300;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 d = points[i] - points[i - 1];
        const double t = std::clamp(dot(p - points[i - 1], d) / squaredLength(d), 0.0, 1.0);
        best = std::min(best, distance(p, points[i - 1] + d * t));
    }
    return best;
}

} // namespace

void tst_Curve::addCurves() {
    QTest::addColumn<int>("number");
    const char* names[] = {"a line",           "an S of Bézier",      "a loop of Bézier",
                           "a quarter circle", "an arc to the right", "a large arc"};
    for (int i = 0; i < 6; ++i) QTest::newRow(names[i]) << i;
}

void tst_Curve::aQuarterCircleHasItsLength() {
    QVERIFY(std::abs(length(quarter) - 0.15707963) < 1e-8); // R = 0.1 m: π/20, as the mesher promises
    QVERIFY(std::abs(length(quarter) - pi / 20) < 1e-15);
}

void tst_Curve::lengthsFollowClosedForms() {
    QVERIFY(std::abs(length({{0, 0}, {0.3, 0.4}, LineShape{}}) - 0.5) < 1e-15);
    QVERIFY(std::abs(length({{0, 0}, {0.2, 0}, ArcShape{1}}) - 0.1 * pi) < 1e-15); // a half circle
    // The parabola y = x² from 0 to 1 as a cubic: ½√5 + ¼·asinh 2. The length is good to about 1e-12.
    const Curve parabola{{0, 0}, {1, 1}, CubicShape{{1.0 / 3, 0}, {2.0 / 3, 1.0 / 3}}};
    QVERIFY(std::abs(length(parabola) - (0.5 * std::sqrt(5.0) + 0.25 * std::asinh(2.0))) < 1e-12);
}

void tst_Curve::splitPartsRunWhereTheWholeRan() {
    QFETCH(int, number);
    const Curve curve = curveNumber(number);
    for (const double at : {0.2, 0.5, 0.77}) {
        const auto [first, second] = splitAt(curve, at);
        for (int i = 0; i <= 10; ++i) {
            const double t = 0.1 * i;
            QVERIFY(distance(pointAt(first, t), pointAt(curve, at * t)) < 1e-14);
            QVERIFY(distance(pointAt(second, t), pointAt(curve, at + (1 - at) * t)) < 1e-14);
        }
    }
}

void tst_Curve::lengthsOfPartsAddUp() {
    QFETCH(int, number);
    const Curve curve = curveNumber(number);
    const auto [first, second] = splitAt(curve, 0.3);
    QVERIFY(std::abs(length(first) + length(second) - length(curve)) < 1e-12 * length(curve));
}

void tst_Curve::reversedRunsBackwards() {
    QFETCH(int, number);
    const Curve curve = curveNumber(number);
    for (int i = 0; i <= 10; ++i)
        QVERIFY(distance(pointAt(reversed(curve), 0.1 * i), pointAt(curve, 1 - 0.1 * i)) < 1e-14);
    QVERIFY(reversed(reversed(curve)) == curve);
}

void tst_Curve::twoMirrorsCancel() {
    QFETCH(int, number);
    const Vec2 a{0.1, 0.2}, b{0.5, -0.3};
    const Curve curve = curveNumber(number), again = mirrored(mirrored(curve, a, b), a, b);
    for (int i = 0; i <= 10; ++i) QVERIFY(distance(pointAt(again, 0.1 * i), pointAt(curve, 0.1 * i)) < 1e-14);
}

void tst_Curve::aMirrorKeepsLengthsAndDistances() {
    QFETCH(int, number);
    const Vec2 a{0.1, 0.2}, b{0.5, -0.3};
    const Curve curve = curveNumber(number), image = mirrored(curve, a, b);
    QVERIFY(std::abs(length(image) - length(curve)) < 1e-12);
    for (int i = 0; i <= 10; ++i) {
        const Vec2 p = pointAt(curve, 0.1 * i), q = pointAt(image, 0.1 * i);
        QVERIFY(std::abs(cross(p - a, b - a) + cross(q - a, b - a)) < 1e-14); // as far on the other side
        QVERIFY(std::abs(dot(p - q, b - a)) < 1e-14);
    }
}

void tst_Curve::flattenedStaysWithinItsError() {
    QFETCH(int, number);
    const Curve curve = curveNumber(number);
    for (const double error : {1e-2, 1e-3, 1e-5}) {
        const auto points = flattened(curve, error);
        QVERIFY(points.front() == curve.start && points.back() == curve.end);
        for (int i = 0; i <= 1000; ++i)
            QVERIFY(distanceToPolyline(points, pointAt(curve, 0.001 * i)) <= error * (1 + 1e-9)); // arcs use it up
    }
}

void tst_Curve::tangentsAreDerivatives() {
    QFETCH(int, number);
    const Curve curve = curveNumber(number);
    constexpr double h = 1e-5; // central differences: error of order h², here below 1e-8
    for (int i = 1; i < 10; ++i) {
        const Vec2 slope = (pointAt(curve, 0.1 * i + h) - pointAt(curve, 0.1 * i - h)) / (2 * h);
        QVERIFY(distance(slope, tangentAt(curve, 0.1 * i)) < 1e-8);
    }
}

void tst_Curve::arcLengthAndParameterAreInverse() {
    QFETCH(int, number);
    const Curve curve = curveNumber(number);
    const ArcLength arc(curve);
    QCOMPARE(arc.parameterAt(0), 0.0);
    QCOMPARE(arc.parameterAt(1), 1.0);
    for (int i = 1; i < 20; ++i) {
        const double t = arc.parameterAt(0.05 * i);
        QVERIFY(std::abs(arc.fractionAt(t) - 0.05 * i) < 1e-12);
        QVERIFY(std::abs(length(splitAt(curve, t).first) - 0.05 * i * arc.total()) < 1e-12);
    }
}

void tst_Curve::aHandleOnItsEndPointStillHasATangent() {
    const Curve curve{{0, 0}, {0.1, 0}, CubicShape{{0, 0}, {0.05, 0.1}}};
    QVERIFY(std::abs(cross(normalized(tangentAt(curve, 0)), normalized(Vec2{0.05, 0.1}))) < 1e-12);
}

void tst_Curve::aCurveWithoutLengthHasItsFractions() {
    const Vec2 point{0.3, -0.1};
    for (const EdgeShape& shape :
         {EdgeShape{LineShape{}}, EdgeShape{ArcShape{0.5}}, EdgeShape{CubicShape{point, point}}}) {
        const ArcLength arc({point, point, shape});
        QCOMPARE(arc.parameterAt(0.4), 0.4);
        QVERIFY(distance(arc.pointAt(0.4), point) < 1e-15);
    }
}

void tst_Curve::aStraightArcIsALine() {
    const Curve arc{{0, 0}, {0.3, 0.4}, ArcShape{0}};
    QCOMPARE(length(arc), 0.5);
    QCOMPARE(pointAt(arc, 0.5), (Vec2{0.15, 0.2}));
    QCOMPARE(flattened(arc, 1e-4).size(), std::size_t(2));
}

void tst_Curve::anEnormousCurveIsFlattenedInFiniteTime() {
    QVERIFY(flattened({{0, 0}, {1e300, 0}, CubicShape{{0, 1e300}, {1, 1}}}, 1e-6).size() <= 1'000'001);
}

TOILE_TEST(tst_Curve)
#include "tst_Curve.moc"
