// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h" // first: moc 6.4 stumbles over <compare> as the first header

#include "samples/SmallScenes.h"

using namespace toile;
using namespace toile::simulation;

namespace {

/// A tube that fits tightly round a post with or without shoulders below its upper opening.
Scene tubeRoundPost(double shoulderHeight) {
    const document::Document tube = samples::tubeRoundCylinder();
    body::Body post{"post", samples::cylinderMesh(), {}, {{body::Limb::torso, {{0, 1, 0}, {0, -0.2, 0}}}}};
    post.landmarks.acromionLeft.y = post.landmarks.acromionRight.y = shoulderHeight;
    return {tube.pattern, Shared<body::Body>(post), tube.scene};
}

SewReport sewn(const Scene& scene, const SewSettings& settings = {}) {
    auto simulation = Simulation::create(scene);
    if (!simulation) qFatal("%s", toString(simulation.error()).c_str());
    auto report = sew(*simulation, settings);
    if (!report) qFatal("%s", toString(report.error()).c_str());
    return std::move(*report);
}

constexpr double farAbove = 2, farBelow = 0; // [m]

} // namespace

/// A garment that only its waistband keeps up goes on after rest, and is judged then.
class tst_Waistband : public QObject {
    Q_OBJECT
private slots:
    void withoutANeckItGoesOnAfterRest();
    void theTimeCanBeChosen();
    void withANeckItEndsAtRest();
    void aRunOfSomeSecondsIsNotProlonged();
};

void tst_Waistband::withoutANeckItGoesOnAfterRest() {
    const SewReport report = sewn(tubeRoundPost(farAbove));
    QVERIFY(report.atRest);
    QVERIFY(std::abs(report.heldSeconds - 10) < 1e-6);
    QVERIFY(report.simulatedSeconds > 10);
    QVERIFY(report.worn->waistDrop);
}

void tst_Waistband::theTimeCanBeChosen() {
    const SewReport held = sewn(tubeRoundPost(farAbove), {.hold = 1}),
                    notHeld = sewn(tubeRoundPost(farAbove), {.hold = 0});
    QVERIFY(std::abs(held.heldSeconds - 1) < 1e-6);
    QCOMPARE(notHeld.heldSeconds, 0.0);
    QVERIFY(std::abs(held.simulatedSeconds - notHeld.simulatedSeconds - 1) < 1e-6); // it still rests, and waits no more
}

void tst_Waistband::withANeckItEndsAtRest() {
    const SewReport report = sewn(tubeRoundPost(farBelow));
    QVERIFY(report.atRest);
    QCOMPARE(report.heldSeconds, 0.0);
    QVERIFY(!report.worn->waistDrop);
}

void tst_Waistband::aRunOfSomeSecondsIsNotProlonged() {
    const SewReport report = sewn(tubeRoundPost(farAbove), {.seconds = 1});
    QCOMPARE(report.heldSeconds, 0.0);
    QVERIFY(std::abs(report.simulatedSeconds - 1) < 1e-9);
}

QTEST_APPLESS_MAIN(tst_Waistband)
#include "tst_Waistband.moc"
