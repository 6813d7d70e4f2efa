// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/AdaptiveTrBdf2.h"
#include "core/study/Trajectory.h"
#include "tests/Suite.h"
#include "tests/dynamics/Constants.h"

#include <QTest>

using namespace toile;
using dynamics::AdaptiveTrBdf2;
using dynamics::StepReport;

namespace {

study::Scene flap(int cells, double stiffnessFactor) {
    return *study::sceneNamed("flap", {cells, stiffnessFactor});
}

/// The flap of 8 × 8 cells after some frame steps.
struct After {
    std::vector<Vec3> positions;
    StepReport report{.parts = 0};
};
After fallen(const study::Scene& sheet, double tolerance, int frames, double smallestStep = 1e-6) {
    AdaptiveTrBdf2 integrator(sheet.model, {{.damping = sheet.damping}, tolerance, smallestStep});
    dynamics::ParticleState state = sheet.start;
    After after;
    for (int i = 0; i < frames; ++i) {
        const auto step = integrator.step(state, 1.0 / 30, gravity);
        if (!step) qFatal("%s", toString(step.error()).c_str());
        after.report += *step;
    }
    after.positions = state.positions;
    return after;
}

} // namespace

class tst_AdaptiveTrBdf2 : public QObject {
    Q_OBJECT

private slots:
    void aTighterToleranceGivesASmallerErrorForMoreParts() {
        const study::Scene sheet = flap(8, 100);
        const After exact = fallen(sheet, 1e-7, 12), coarse = fallen(sheet, 1e-3, 12), fine = fallen(sheet, 1e-5, 12);
        const double coarseError = rmsDistance(sheet, coarse.positions, exact.positions);
        const double fineError = rmsDistance(sheet, fine.positions, exact.positions);
        QVERIFY(fine.report.parts > 2 * coarse.report.parts);
        QVERIFY(fineError < 0.2 * coarseError);
        QVERIFY(coarseError < 12 * 1e-3 && fineError < 12 * 1e-5 * 10); // the errors of parts add up
        QVERIFY(coarse.report.accurate && fine.report.accurate && exact.report.accurate);
    }

    void stiffWavesDoNotDictateTheStep() {
        const After soft = fallen(flap(8, 1), 1e-3, 12), stiff = fallen(flap(8, 1e4), 1e-3, 12);
        QVERIFY(stiff.report.parts <= 3 * soft.report.parts);
    }

    void whatHangsStillTakesWholeSteps() {
        study::Scene sheet = flap(4, 1);
        for (Vec3& p : sheet.start.positions) p = {p.x, -p.z, 0}; // hanging, nearly at rest
        const int frames = 30;
        AdaptiveTrBdf2 integrator(sheet.model, {{.damping = 10}, 1e-3});
        int parts = 0;
        for (int i = 0; i < frames; ++i) {
            const auto step = integrator.step(sheet.start, 1.0 / 60, gravity);
            QVERIFY(step);
            parts = step->parts;
        }
        QCOMPARE(parts, 1);
    }

    void theSmallestPartIsTakenWithAFlagAndNeverALoop() {
        const study::Scene sheet = flap(4, 100);
        const After after = fallen(sheet, 1e-30, 1, 1.0 / 300); // no step is ever good enough
        QVERIFY(!after.report.accurate);
        QVERIFY(after.report.parts >= 8 && after.report.parts <= 20);
        QVERIFY(after.report.repeated > 0);
    }

    void aToleranceMakesTheMethodAdaptive() {
        const study::Scene sheet = flap(8, 100);
        const auto partsOf = [&](double tolerance) {
            dynamics::ParticleState state = sheet.start;
            const auto integrator =
                dynamics::makeIntegrator(dynamics::Method::trBdf2, sheet.model, {.positionTolerance = tolerance});
            int parts = 0;
            for (int i = 0; i < 12; ++i) {
                const auto step = integrator->step(state, 1.0 / 30, gravity);
                if (!step) qFatal("%s", toString(step.error()).c_str());
                parts += step->parts;
            }
            return parts;
        };
        QCOMPARE(partsOf(0), 12);
        QVERIFY(partsOf(1e-6) > 24);
    }

    void aJoltShortensTheParts() {
        study::Scene sheet = flap(8, 100);
        AdaptiveTrBdf2 integrator(sheet.model, {{.damping = sheet.damping}, 1e-4});
        const auto calm = integrator.step(sheet.start, 1.0 / 240, gravity);
        for (std::size_t p = 0; p < sheet.start.velocities.size(); p += 2) sheet.start.velocities[p].y += 5;
        const auto jolted = integrator.step(sheet.start, 1.0 / 240, gravity);
        QVERIFY(calm && jolted);
        QVERIFY(jolted->parts > calm->parts && jolted->repeated > 0);
    }
};

TOILE_TEST(tst_AdaptiveTrBdf2)
#include "tst_AdaptiveTrBdf2.moc"
