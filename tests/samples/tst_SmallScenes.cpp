// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest> // first: moc 6.4 stumbles over <compare> as the first header

#include "core/simulation/FrameTally.h"
#include "core/simulation/Sew.h"
#include "samples/RegionScenes.h"
#include "samples/SmallScenes.h"
#include "tests/Suite.h"

#include <cmath>
#include <numbers>

using namespace toile;

class tst_SmallScenes : public QObject {
    Q_OBJECT
private slots:
    void aTightTubeIsAsSmoothAsItsBody_data();
    void aTightTubeIsAsSmoothAsItsBody();
    void aStripStaysOnTheTableAndHangsOverItsEdge();
    void aBandIsButtonedRightOverLeft_data();
    void aBandIsButtonedRightOverLeft();
    void noFrameShowsClothInTheBodyOrInItself_data();
    void noFrameShowsClothInTheBodyOrInItself();
};

void tst_SmallScenes::aTightTubeIsAsSmoothAsItsBody_data() {
    QTest::addColumn<double>("spacing");
    QTest::newRow("20 mm") << 0.02;
    QTest::newRow("10 mm") << 0.01;
}

/// Neither the sewing, nor the facets of the body, nor the lattice of its smooth distance leave ripples in cloth that
/// is pressed on it.
void tst_SmallScenes::aTightTubeIsAsSmoothAsItsBody() {
    QFETCH(double, spacing);
    const document::Document tube = samples::tubeRoundCylinder();
    const simulation::Scene scene{
        tube.pattern, Shared<body::Body>(body::Body{"cylinder", samples::cylinderMesh(), {}, {}}), tube.scene};
    auto simulation = simulation::Simulation::create(scene, {.spacing = spacing});
    QVERIFY(simulation);
    const auto report = simulation::sew(*simulation, {});
    QVERIFY(report && report->reachedItsGoal({}));
    // Round a radius of 0.103 m along weft, straight along warp; its free ends are drawn in a little. The alternating
    // part of a smooth bend is nothing; 1 % of it would be hills of 2 µm on a mesh of 10 mm.
    const double round = 1 / (0.103 * std::numbers::sqrt2);
    QVERIFY2(report->curvature.rms > round && report->curvature.rms < 1.3 * round,
             QByteArray::number(report->curvature.rms));
    QVERIFY2(report->curvature.alternating < 0.01 * report->curvature.rms,
             QByteArray::number(report->curvature.alternating));
}

void tst_SmallScenes::aStripStaysOnTheTableAndHangsOverItsEdge() {
    constexpr double top = 0.735, edge = 0.45, rim = 0.04, hanging = 0.2; // of the table, and of the strip over it [m]
    const document::Document strip = samples::tableEdge();
    const simulation::Scene scene{strip.pattern, Shared<body::Body>(body::Body{"table", samples::tableMesh(), {}, {}}),
                                  strip.scene};
    auto simulation = simulation::Simulation::create(scene, {.spacing = 0.025});
    QVERIFY(simulation);
    const auto report = simulation::sew(*simulation, {});
    QVERIFY(report && report->atRest);
    double behind = 0, lowest = top;
    for (const Vec3& p : simulation->state().positions) {
        behind = std::min(behind, p.z);
        lowest = std::min(lowest, p.y);
    }
    const double slipped = behind - (edge - 0.8); // as it falls; then friction holds 0.8 m against the weight of 0.2
    QVERIFY2(slipped > -1e-3 && slipped < 0.01, QByteArray::number(slipped));
    // The corners hang over the round edge by more than the middle. Round the rim the strip goes a quarter of a circle;
    // its bend takes a little.
    const double over = hanging + slipped + edge - std::sqrt(edge * edge - 0.1 * 0.1);
    const double below = over + 2 * rim - std::numbers::pi / 2 * (rim + strip.scene.skinOffset);
    QVERIFY2(lowest > top - below && lowest < top - 0.9 * below, QByteArray::number(lowest));
}

void tst_SmallScenes::aBandIsButtonedRightOverLeft_data() {
    QTest::addColumn<double>("leftStart");
    QTest::addColumn<double>("rightStart");
    QTest::addColumn<double>("spacing");
    QTest::newRow("both drawn at one radius") << 0.125 << 0.125 << 0.02;
    QTest::newRow("drawn in the wrong order") << 0.13 << 0.12 << 0.02;
    QTest::newRow("on a finer mesh") << 0.125 << 0.125 << 0.01;
}

void tst_SmallScenes::aBandIsButtonedRightOverLeft() {
    QFETCH(double, leftStart);
    QFETCH(double, rightStart);
    QFETCH(double, spacing);
    const document::Document band = samples::buttonedBand({.leftStart = leftStart, .rightStart = rightStart});
    const simulation::Scene scene{
        band.pattern, Shared<body::Body>(body::Body{"cylinder", samples::cylinderMesh(), {}, {}}), band.scene};
    auto simulation = simulation::Simulation::create(scene, {.spacing = spacing});
    QVERIFY(simulation);
    const auto report = simulation::sew(*simulation, {});
    QVERIFY2(report, report ? "" : toString(report.error()).c_str());
    QVERIFY(report->allClosed() && report->allTacked() && report->atRest && report->contact.outsideBody);
    QCOMPARE(report->tacks.size(), std::size_t(3));
    QCOMPARE(report->contact.selfIntersections, 0);
    QCOMPARE(report->contact.nodesInWrongOrder, 0);
    QVERIFY(report->contact.guarantee);
    const auto radius = [&](const simulation::MeshPoint& place) {
        Vec3 at;
        const std::vector<Vec3> nodes = simulation->nodePositions();
        for (std::size_t k = 0; k < 3; ++k)
            at += place.weights[k] * nodes[simulation->garment().particles.node({place.piece, place.nodes[k]})];
        return std::hypot(at.x, at.z);
    };
    for (const simulation::TackState& tack : simulation->tacks())
        QVERIFY(radius(tack.ends[1]) > radius(tack.ends[0])); // the hole lies over the button's side
}

void tst_SmallScenes::noFrameShowsClothInTheBodyOrInItself_data() {
    QTest::addColumn<document::Document>("sample");
    QTest::addColumn<geometry::TriangleMesh>("body");
    QTest::newRow("tablecloth") << samples::tablecloth() << samples::tableMesh();
    QTest::newRow("finer over rod") << samples::finerOverRod() << samples::rodMesh();
}

/// Cells bridge the rim, corners strike folds and ends swing towards each other in the first second and a half.
void tst_SmallScenes::noFrameShowsClothInTheBodyOrInItself() {
    QFETCH(const document::Document, sample);
    QFETCH(const geometry::TriangleMesh, body);
    const simulation::Scene scene{sample.pattern, Shared<body::Body>(body::Body{"body", body, {}, {}}), sample.scene};
    auto simulation = simulation::Simulation::create(scene);
    QVERIFY(simulation);
    simulation::FrameTally tally;
    const auto look = [&](const simulation::Simulation& now) {
        tally.add(now.state().time, simulation::intersectionsOf(now));
    };
    QVERIFY(simulation::sew(*simulation, {.seconds = 1.7}, {}, {}, look));
    QVERIFY(tally.frames > 100);
    QVERIFY2(tally.withBody.frames == 0 && tally.withItself.frames == 0, simulation::describe(tally).c_str());
}

TOILE_TEST(tst_SmallScenes, QCoreApplication)
#include "tst_SmallScenes.moc"
