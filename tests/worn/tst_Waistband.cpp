// SPDX-License-Identifier: GPL-3.0-or-later
#include "PostScenes.h" // first: moc 6.4 stumbles over <compare> as the first header
#include "tests/Suite.h"

#include "core/material/FabricPresets.h"
#include "samples/CircleSkirt.h"
#include "samples/GatheredSkirt.h"
#include "samples/Waistband.h"

using namespace toile;
using namespace toile::simulation;

/// A garment that only its waistband keeps up goes on after rest, and is judged then.
class tst_Waistband : public QObject {
    Q_OBJECT
private slots:
    void withoutANeckItGoesOnAfterRest();
    void theTimeCanBeChosen();
    void withANeckItEndsAtRest();
    void aRunOfSomeSecondsIsNotProlonged();
    void aTightBandDoesNotCreepRoundTheBody();
    void aSkirtInDeepFoldsIsPutOnRight();
    void gathersDoNotStretchTheBandTheyHangOn();
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

/// Hoop tension presses the band on with ten times the friction that its weight needs, and no force turns it.
void tst_Waistband::aTightBandDoesNotCreepRoundTheBody() {
    const material::Fabric fabric = samples::interlined(material::poplin());
    pattern::Pattern pattern;
    pattern.fabrics = {fabric};
    const pattern::Piece band =
        samples::draftWaistband(fabric, mannequin().body, {mannequin().measurements.waist, 0.035, 0.025}, 0.0175);
    pattern.pieces = {band};
    pattern.seams = {samples::waistbandSeam(band)};
    Scene scene = onMannequin(pattern);
    scene.settings.substeps = samples::waistbandSubsteps;
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    const auto goOnTo = [&](double time) {
        while (simulation->state().time < time)
            if (!simulation->advance()) qFatal("the band flew away");
        return simulation->state().positions;
    };
    const std::vector<Vec3> before = goOnTo(5), after = goOnTo(7);
    QVERIFY(simulation->allSeamsMerged());
    double farthest = 0;
    for (std::size_t p = 0; p < before.size(); ++p) farthest = std::max(farthest, distance(before[p], after[p]));
    QVERIFY2(farthest < 0.0005, qPrintable(QString("%1 mm").arg(1000 * farthest)));
}

/// Coarse, and looked at before it rests: how it lies is right, how far it is stretched is not asked yet.
void tst_Waistband::aSkirtInDeepFoldsIsPutOnRight() {
    const document::Document skirt =
        samples::circleSkirt(mannequin().measurements, mannequin().body, {.spacing = 0.040});
    Scene scene = onMannequin(skirt.pattern);
    scene.settings = skirt.scene;
    const SewReport report = sewnFor(4, scene);
    QVERIFY(report.allClosed());
    for (const char* words :
         {"wrong side", "right side out", "is crossed", "No limb", "the level it was placed", "Left and right"})
        QVERIFY2(!says(report, words), reasonsOf(report).c_str());
    QCOMPARE(report.contact.selfIntersections, 0);
    QCOMPARE(report.worn->rightSideOut, 1.0);
    QVERIFY(report.worn->symmetryDifference); // of the waist, not of the hem
}

/// 1.17 m of cloth in 0.73 m of band. Were the gathers not drawn up, the band's edge would be 0.9 m long.
void tst_Waistband::gathersDoNotStretchTheBandTheyHangOn() {
    const document::Document skirt = samples::gatheredSkirt(mannequin().measurements, mannequin().body);
    Scene scene = onMannequin(skirt.pattern);
    scene.settings = skirt.scene;
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    while (simulation->state().time < 3)
        if (!simulation->advance()) qFatal("the skirt flew away");
    QVERIFY(simulation->allSeamsMerged());
    const auto& garment = simulation->garment();
    double length = 0;
    for (const int seam : {2, 3}) {
        const auto& pairs = garment.mesh->seams[seam].pairs;
        for (std::size_t i = 1; i < pairs.size(); ++i)
            length += distance(simulation->state().positions[garment.particles.particle(pairs[i - 1][1])],
                               simulation->state().positions[garment.particles.particle(pairs[i][1])]);
    }
    const double band = mannequin().measurements.waist + samples::GatheredSkirtSettings{}.waistEase;
    QVERIFY2(std::abs(length / band - 1) < 0.03, qPrintable(QString("%1 m").arg(length)));
}

TOILE_TEST(tst_Waistband)
#include "tst_Waistband.moc"
