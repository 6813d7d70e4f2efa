// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtTest> // first: moc 6.4 stumbles over <compare> as the first header

#include "core/simulation/Sew.h"
#include "samples/SmallScenes.h"

#include <numbers>

using namespace toile;

class tst_SmallScenes : public QObject {
    Q_OBJECT
private slots:
    void aTightTubeIsAsSmoothAsItsBody_data();
    void aTightTubeIsAsSmoothAsItsBody();
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

QTEST_GUILESS_MAIN(tst_SmallScenes)
#include "tst_SmallScenes.moc"
