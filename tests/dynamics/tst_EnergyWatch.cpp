// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/EnergyWatch.h"
#include "core/dynamics/Xpbd.h"
#include "core/study/Scenes.h"
#include "tests/Suite.h"
#include "tests/dynamics/Constants.h"

#include <QTest>

using namespace toile;
using dynamics::EnergyWatch;
using dynamics::ParticleState;

namespace {

/// Two particles of 0.1 kg on a spring of 100 N/m and 0.1 m.
cloth::ClothModel pair() {
    cloth::ClothModel model;
    model.mass = {0.1, 0.1};
    model.structural = {{0, 1, 0.1, 100}};
    return model;
}

/// The pair, so long and so high, its ends going apart and up so fast.
ParticleState pairAt(double length, double height, double apart, double up) {
    return {.positions = {{0, height, 0}, {length, height, 0}}, .velocities = {{-apart, up, 0}, {apart, up, 0}}};
}

} // namespace

class tst_EnergyWatch : public QObject {
    Q_OBJECT
private slots:
    void whatFallsGainsNothing();
    void aSpringThatLetsGoGivesWhatItHeld();
    void speedFromNowhereIsSeen();
    void heightFromNowhereIsSeen();
    void littleIsMeasuredByWhatWasTurnedOver();
    void fallingClothIsNotAccused();
};

void tst_EnergyWatch::whatFallsGainsNothing() {
    const auto model = pair();
    EnergyWatch watch(model, gravity);
    const double h = 0.1, v = 9.81 * h;
    QVERIFY(!watch.gains(pairAt(0.1, 1, 0, 0), pairAt(0.1, 1 - 0.5 * v * h, 0, -v)));
}

void tst_EnergyWatch::aSpringThatLetsGoGivesWhatItHeld() {
    const auto model = pair();
    EnergyWatch watch(model, {});
    // ½·100·0.1² = 0.5 J become 2·½·0.1·v²
    const double speed = std::sqrt(5.0);
    QVERIFY(!watch.gains(pairAt(0.2, 0, 0, 0), pairAt(0.1, 0, -speed, 0)));
    QVERIFY(watch.gains(pairAt(0.2, 0, 0, 0), pairAt(0.1, 0, -1.1 * speed, 0)));
}

void tst_EnergyWatch::speedFromNowhereIsSeen() {
    const auto model = pair();
    EnergyWatch watch(model, gravity);
    QVERIFY(watch.gains(pairAt(0.1, 1, 0, 0), pairAt(0.1, 1, 0.1, 0)));
    QVERIFY(!watch.gains(pairAt(0.1, 1, 0.1, 0), pairAt(0.1, 1, 0, 0))); // it may be lost
}

void tst_EnergyWatch::heightFromNowhereIsSeen() {
    const auto model = pair();
    EnergyWatch watch(model, gravity);
    QVERIFY(watch.gains(pairAt(0.1, 1, 0, 0), pairAt(0.1, 1.01, 0, 0)));
}

void tst_EnergyWatch::littleIsMeasuredByWhatWasTurnedOver() {
    const auto model = pair();
    EnergyWatch watch(model, gravity, 0.01);
    const ParticleState still = pairAt(0.1, 1, 0, 0), quick = pairAt(0.1, 1, 0.05, 0); // 2.5e-4 J
    QVERIFY(watch.gains(still, quick));                                  // of 2e-3 J, to lift it by a millimetre
    QVERIFY(!watch.gains(pairAt(0.1, 1, 0, 1), pairAt(0.1, 1, 0, 0.9))); // 0.1 J
    QVERIFY(!watch.gains(still, quick));
}

/// Position-based steps of cloth that falls, is caught by its edge and swings.
void tst_EnergyWatch::fallingClothIsNotAccused() {
    for (const int substeps : {10, 40}) {
        study::Scene flap = *study::sceneNamed("flap", {16, 1});
        dynamics::Xpbd xpbd(flap.model, {.damping = 0});
        EnergyWatch watch(flap.model, flap.gravity);
        for (int i = 0; i < 60; ++i) {
            const ParticleState before = flap.start;
            QVERIFY(xpbd.step(flap.start, 1.0 / 60, substeps, flap.gravity, {}));
            QVERIFY(!watch.gains(before, flap.start));
        }
    }
}

TOILE_TEST(tst_EnergyWatch)
#include "tst_EnergyWatch.moc"
