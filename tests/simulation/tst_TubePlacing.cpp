// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/Clearing.h"
#include "core/simulation/TubePlacing.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double bend = 0.35;      // radius of the limb's middle line [m]
constexpr double thickness = 0.04; // radius of the limb [m]
constexpr double whole = 0.5;      // length of the limb [m]

/// The middle line of a bent limb: an arc in the plane y, z, of a centimetre's steps as limbLine gives.
geometry::Polyline bentLimb() {
    geometry::Polyline line;
    for (int i = 0; i <= 50; ++i) {
        const double a = whole / bend * i / 50;
        line.push_back({0, -bend * std::sin(a), bend * (1 - std::cos(a))});
    }
    return line;
}

geometry::Polyline straightLimb() {
    return {{0, 0, 0}, {0, -whole, 0}};
}

/// Distance to the arc, of which the points lie within a chord's height: 0.01² / (8 · bend) = 0.04 mm.
double distanceToArc(const Vec3& p) {
    return std::hypot(std::hypot(p.y, p.z - bend) - bend, p.x);
}
constexpr double chord = 4e-5;

/// The limb as a closed body: rings of 48 corners along the arc, and two caps.
collision::BodySurface limbSurface() {
    geometry::TriangleMesh mesh;
    constexpr int around = 48;
    const geometry::Polyline line = bentLimb();
    const int rings = static_cast<int>(line.size());
    for (int i = 0; i < rings; ++i) {
        const Transform frame = geometry::frameAlong(line, whole * i / (rings - 1), {1, 0, 0});
        for (int k = 0; k < around; ++k) {
            const double a = 2 * std::numbers::pi * k / around;
            mesh.vertices.push_back(frame.point({thickness * std::cos(a), 0, thickness * std::sin(a)}));
        }
    }
    for (int i = 0; i + 1 < rings; ++i)
        for (int k = 0; k < around; ++k) {
            const int a = i * around + k, b = i * around + (k + 1) % around;
            mesh.triangles.push_back({a, a + around, b});
            mesh.triangles.push_back({b, a + around, b + around});
        }
    for (int k = 1; k + 1 < around; ++k) {
        const int last = (rings - 1) * around;
        mesh.triangles.push_back({0, k, k + 1});
        mesh.triangles.push_back({last, last + k + 1, last + k});
    }
    return std::move(*collision::BodySurface::create(std::move(mesh)));
}

/// A sleeve of 0.4 m by 0.3 m, its wrist below.
pattern::Piece sleeve() {
    return polygonPiece("sleeve", {{-0.2, -0.3}, {0.2, -0.3}, {0.2, 0}, {-0.2, 0}}, 0.02);
}

/// Rolled so that its edges nearly meet, a hand's breadth down the limb, its middle facing +x.
TubePlace sleevePlace() {
    return {.axis = {0, 1},
            .towardsEnd = false,
            .at = 0.1,
            .upper = {1, 0, 0},
            .middle = 0,
            .radius = 0.4 / (2 * std::numbers::pi * 0.94)};
}

} // namespace

class tst_TubePlacing : public QObject {
    Q_OBJECT
private slots:
    void roundABentLimbATubeKeepsItsGirth();
    void roundABentLimbATubeKeepsItsDistanceEverywhere();
    void theMiddleLinesKeepTheirLength();
    void itsRightSideFacesOutward();
    void onAStraightLimbNothingIsBent();
    void theAxisMayPointToEitherEnd();
    void theMiddleOfThePieceFacesWhereItIsAsked();
    void aTubeThatIsTooTightIsWidened();
    void beyondTheWristATubeIsMovedUp();
};

void tst_TubePlacing::roundABentLimbATubeKeepsItsGirth() {
    const pattern::Placement placement = placedRound(bentLimb(), sleevePlace(), -0.3, 0);
    QVERIFY(placement.curl->bent);
    for (const double t : {-0.3, -0.17, -0.05, 0.0}) {
        double girth = 0;
        constexpr int parts = 400; // chords of a circle: relative error (step/R)²/24 = 1e-5
        for (int i = 0; i < parts; ++i)
            girth += geometry::distance(pattern::placed(placement, {-0.2 + 0.4 * i / parts, t}),
                                        pattern::placed(placement, {-0.2 + 0.4 * (i + 1) / parts, t}));
        QVERIFY(std::abs(girth - 0.4) < 1e-5);
    }
}

void tst_TubePlacing::roundABentLimbATubeKeepsItsDistanceEverywhere() {
    const TubePlace place = sleevePlace();
    const pattern::Placement placement = placedRound(bentLimb(), place, -0.3, 0);
    for (const Vec2 point : pointsOn(sleeve()))
        QVERIFY(std::abs(distanceToArc(pattern::placed(placement, point)) - place.radius) < 2 * chord);
    QVERIFY(isClear(pointsOn(sleeve()), placement, limbSurface()));
    pattern::Placement straight = placement; // as it would lie without following the limb
    straight.curl->bent.reset();
    QVERIFY(!isClear(pointsOn(sleeve()), straight, limbSurface()));
}

void tst_TubePlacing::theMiddleLinesKeepTheirLength() {
    // Beside the plane of the bend lines are as long as the limb's own: a quarter turn from the middle, which
    // faces +x, they run outside and inside, longer and shorter by R/ρ.
    const TubePlace place = sleevePlace();
    const pattern::Placement placement = placedRound(bentLimb(), place, -0.3, 0);
    const auto lengthAt = [&](double s) {
        double sum = 0;
        for (int i = 0; i < 300; ++i)
            sum += geometry::distance(pattern::placed(placement, {s, -0.3 + 0.001 * i}),
                                      pattern::placed(placement, {s, -0.299 + 0.001 * i}));
        return sum;
    };
    const double quarter = 0.5 * std::numbers::pi * place.radius;
    constexpr double tolerance = 1e-3; // steps of a centimetre along the line
    QVERIFY(std::abs(lengthAt(0) - 0.3) < tolerance);
    QVERIFY(std::abs(lengthAt(quarter) + lengthAt(-quarter) - 0.6) < tolerance);
    QVERIFY(std::abs(std::abs(lengthAt(quarter) - lengthAt(-quarter)) - 0.6 * place.radius / bend) < tolerance);
}

void tst_TubePlacing::itsRightSideFacesOutward() {
    const pattern::Placement placement = placedRound(bentLimb(), sleevePlace(), -0.3, 0);
    for (const Vec2 point : {Vec2{0, -0.1}, Vec2{0.12, -0.2}, Vec2{-0.15, -0.02}}) {
        const Vec3 p = pattern::placed(placement, point);
        const Vec3 normal = cross(pattern::placed(placement, point + Vec2{1e-4, 0}) - p,
                                  pattern::placed(placement, point + Vec2{0, 1e-4}) - p);
        QVERIFY(distanceToArc(p + normalized(normal) * 0.01) > distanceToArc(p));
    }
}

void tst_TubePlacing::onAStraightLimbNothingIsBent() {
    const pattern::Placement placement = placedRound(straightLimb(), sleevePlace(), -0.3, 0);
    QVERIFY(!placement.curl->bent);
    QVERIFY(geometry::distance(placement.transform.origin, {sleevePlace().radius, -0.1, 0}) < 1e-12);
    QVERIFY(geometry::distance(placement.transform.axisY, {0, 1, 0}) < 1e-12); // to the root
}

void tst_TubePlacing::theAxisMayPointToEitherEnd() {
    TubePlace place = sleevePlace();
    place.towardsEnd = true;
    const pattern::Placement placement = placedRound(straightLimb(), place, -0.3, 0);
    QVERIFY(geometry::distance(placement.transform.axisY, {0, -1, 0}) < 1e-12);
    QVERIFY(geometry::distance(placement.transform.axisZ, {1, 0, 0}) < 1e-12); // still outward
}

void tst_TubePlacing::theMiddleOfThePieceFacesWhereItIsAsked() {
    for (const geometry::Polyline& limb : {straightLimb(), bentLimb()}) {
        TubePlace place = sleevePlace();
        place.middle = 0.13;
        const pattern::Placement placement = placedRound(limb, place, -0.3, 0);
        const Vec3 onLine = geometry::frameAlong(limb, place.at, place.upper).origin;
        QVERIFY(geometry::distance(pattern::placed(placement, {0.13, 0}) - onLine, Vec3{place.radius, 0, 0}) < 1e-4);
    }
}

void tst_TubePlacing::aTubeThatIsTooTightIsWidened() {
    TubePlace tight = sleevePlace();
    tight.radius = thickness + 0.004;
    const std::vector<Vec2> points = pointsOn(sleeve());
    const collision::BodySurface limb = limbSurface();
    QVERIFY(!isClear(points, placedRound(bentLimb(), tight, -0.3, 0), limb));
    const auto placement = clearRound(bentLimb(), whole, tight, points, limb);
    QVERIFY(placement);
    QVERIFY(placement->curl->radius > tight.radius);
    QVERIFY(isClear(points, *placement, limb));
}

void tst_TubePlacing::beyondTheWristATubeIsMovedUp() {
    // A knob at the limb's end, as a hand: the tube is clear above it and below it.
    const collision::BodySurface limb = limbSurface();
    TubePlace place = sleevePlace();
    place.radius = thickness + 0.001; // clear nowhere along the limb, only beyond its end or above its root
    const std::vector<Vec2> points =
        pointsOn(polygonPiece("cuff", {{-0.1, -0.04}, {0.1, -0.04}, {0.1, 0}, {-0.1, 0}}, 0.02));
    const geometry::Polyline line = bentLimb();
    const auto placeOf = [&](const pattern::Placement& p) {
        return geometry::nearestArcLength(line, p.transform.point({0, 0, -p.curl->radius}));
    };
    place.at = 0.18;
    QVERIFY(placeOf(*clearRound(line, 0.1, place, points, limb)) < 0); // it would reach beyond an end at 0.1: up
    place.at = 0.34;
    QVERIFY(placeOf(*clearRound(line, whole, place, points, limb)) > whole); // it would not: down
}

TOILE_TEST(tst_TubePlacing)
#include "tst_TubePlacing.moc"
