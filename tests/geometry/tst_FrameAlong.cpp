// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/FrameAlong.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile::geometry;

class tst_FrameAlong : public QObject {
    Q_OBJECT
private slots:
    void onAStraightLineItIsThatOfThePlacement();
    void beyondItsEndsALineGoesOnStraight();
    void onAnArcItStandsSquareAndDoesNotTurnAboutTheLine();
    void theNearestPlaceIsFoundBeyondTheEndsToo();
    void roundedAStraightLineStays();
    void roundedACornerKeepsAwayFromItsTip();
};

namespace {

/// A circle's arc in the plane y, z: from the origin upward, bending towards +z.
Polyline arc(double radius, double angle, int parts) {
    Polyline line;
    for (int i = 0; i <= parts; ++i) {
        const double a = angle * i / parts;
        line.push_back({0, radius * std::sin(a), radius * (1 - std::cos(a))});
    }
    return line;
}

const Vec3 front{0, 0, 1};

} // namespace

void tst_FrameAlong::onAStraightLineItIsThatOfThePlacement() {
    const Polyline line{{0, 0, 0}, {0, 0.1, 0}, {0, 0.4, 0}};
    const Transform frame = frameAlong(line, 0.25, front);
    QCOMPARE(frame.axisX, (Vec3{1, 0, 0}));
    QCOMPARE(frame.axisY, (Vec3{0, 1, 0}));
    QCOMPARE(frame.axisZ, front);
    QVERIFY(distance(frame.origin, {0, 0.25, 0}) < 1e-15);
    QVERIFY(std::abs(arcLength(line) - 0.4) < 1e-15);
}

void tst_FrameAlong::beyondItsEndsALineGoesOnStraight() {
    const Polyline line{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}};
    QVERIFY(distance(frameAlong(line, -0.5, front).origin, {0, -0.5, 0}) < 1e-15);
    QVERIFY(distance(frameAlong(line, 2.5, front).origin, {0, 1, 1.5}) < 1e-15);
    QVERIFY(distance(frameAlong(line, 2.5, front).axisY, front) < 1e-15);
}

void tst_FrameAlong::onAnArcItStandsSquareAndDoesNotTurnAboutTheLine() {
    constexpr double radius = 0.3, angle = 1.2;
    const Polyline line = arc(radius, angle, 240);
    for (const double share : {0.0, 0.31, 0.5, 0.87, 1.0}) {
        const Transform frame = frameAlong(line, share * arcLength(line), front);
        const double a = share * angle;
        constexpr double chords = 3e-3; // a direction at the ends is that of a chord: half a part off, 0.0025 rad
        QVERIFY(distance(frame.axisY, {0, std::cos(a), std::sin(a)}) < chords);
        QVERIFY(distance(frame.axisX, {1, 0, 0}) < 1e-12);
        QVERIFY(std::abs(dot(frame.axisY, frame.axisZ)) < 1e-12);
    }
}

void tst_FrameAlong::theNearestPlaceIsFoundBeyondTheEndsToo() {
    const Polyline line{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}};
    QVERIFY(std::abs(nearestArcLength(line, {0.2, 0.4, -0.1}) - 0.4) < 1e-15);
    QVERIFY(std::abs(nearestArcLength(line, {0.2, -0.3, 0}) + 0.3) < 1e-15);
    QVERIFY(std::abs(nearestArcLength(line, {0, 1.1, 1.7}) - 2.7) < 1e-15);
}

void tst_FrameAlong::roundedAStraightLineStays() {
    const Polyline line = rounded(Polyline{{0, 0, 0}, {0.1, 0, 0}, {0.5, 0, 0}}, 0.01, 0.05);
    QCOMPARE(line.size(), std::size_t{51});
    for (std::size_t i = 0; i < line.size(); ++i)
        QVERIFY(distance(line[i], {0.01 * static_cast<double>(i), 0, 0}) < 1e-12);
}

void tst_FrameAlong::roundedACornerKeepsAwayFromItsTip() {
    const Polyline corner{{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, line = rounded(corner, 0.01, 0.05);
    // At the tip both arms weigh the same: the mean of |t| under the bell on each, √(2/π)·σ / 2.
    const double inward = 0.05 * std::sqrt(2 / std::numbers::pi) / 2;
    constexpr double sampled = 2e-4; // the bell is cut at three deviations, and summed in steps
    QVERIFY(distance(line[100], {-inward, inward, 0}) < sampled);
    QVERIFY(distance(line.front(), corner.front()) < 1e-12);
}

TOILE_TEST(tst_FrameAlong)
#include "tst_FrameAlong.moc"
