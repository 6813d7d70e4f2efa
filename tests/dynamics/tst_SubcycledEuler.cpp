// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/RungeKutta4.h"
#include "core/dynamics/SubcycledEuler.h"
#include "core/dynamics/SymplecticEuler.h"
#include "tests/Suite.h"
#include "tests/dynamics/Specimen.h"

#include <QTest>

using namespace toile;
using namespace toile::fixtures;
using dynamics::Integrator;
using dynamics::ParticleState;
using dynamics::SubcycledEuler;

namespace {

/// A horizontal sheet pinned at two corners.
Specimen cornerHeldSheet(const Patch& patch) {
    Specimen c;
    if (auto report = cloth::appendPatch(c.model, patch, wovenFabric()); !report)
        qFatal("%s", toString(report.error()).c_str());
    c.model.pinned = {0, 4};
    for (const Vec3& flat : flatPositions(patch)) c.state.positions.push_back({flat.x, 0, flat.y});
    c.state.velocities.resize(c.state.positions.size());
    return c;
}

Specimen evenSheet() {
    return cornerHeldSheet(gridPatch(evenLines(0.2, 4), evenLines(0.2, 4)));
}

/// Half of it four times as fine.
Specimen regionSheet() {
    return cornerHeldSheet(twoRegionPatch(0.2, 4, 0.1, 2, 0.2, 8, 4));
}

double largestDistance(const ParticleState& a, const ParticleState& b) {
    double largest = 0;
    for (std::size_t p = 0; p < a.positions.size(); ++p)
        largest = std::max(largest, geometry::distance(a.positions[p], b.positions[p]));
    return largest;
}

std::int64_t elementsOf(const ClothModel& m) {
    return static_cast<std::int64_t>(m.structural.size() + m.shear.size() + m.bending.size() + m.twist.size() +
                                     m.hinges.size() + m.triangles.size() + m.cells.size());
}

} // namespace

/// What the contract of all integrators does not ask: that parts of a cloth have steps of their own.
class tst_SubcycledEuler : public QObject {
    Q_OBJECT

private slots:
    void onOneLevelItIsSymplecticEuler() {
        Specimen c = evenSheet();
        ParticleState whole = c.state;
        SubcycledEuler own(c.model, {.damping = 0.5, .levels = 1});
        dynamics::SymplecticEuler euler(c.model, {.damping = 0.5});
        run(own, c.state, 12, 1.0 / 60);
        run(euler, whole, 12, 1.0 / 60);
        QVERIFY(largestDistance(c.state, whole) < 1e-12);
    }

    void coarseElementsPushLessOften() {
        Specimen c = regionSheet();
        SubcycledEuler integrator(c.model);
        const auto report = integrator.step(c.state, 1.0 / 60, gravity);
        QVERIFY(report);
        const std::int64_t all = elementsOf(c.model) * report->parts;
        // 8 of 136 cells are coarse; they and the joint push a half or a quarter as often.
        QVERIFY(integrator.elementPushes() < 0.97 * static_cast<double>(all));
        QVERIFY(integrator.elementPushes() > all / 4);
    }

    /// Against steps that are fine everywhere, and against the truth: first order in the step.
    void itsErrorIsThatOfFineStepsEverywhere() {
        Specimen start = regionSheet();
        ParticleState truth = start.state, fine = start.state, own = start.state, finer = start.state;
        dynamics::RungeKutta4 rk4(start.model, {.safety = 0.3});
        dynamics::SymplecticEuler euler(start.model);
        SubcycledEuler subcycled(start.model), half(start.model, {.safety = 0.45});
        constexpr int steps = 12;
        run(rk4, truth, steps, 1.0 / 60);
        run(euler, fine, steps, 1.0 / 60);
        run(subcycled, own, steps, 1.0 / 60);
        run(half, finer, steps, 1.0 / 60);
        const double error = largestDistance(own, truth), ofFine = largestDistance(fine, truth);
        QVERIFY2(error < 4 * ofFine, qPrintable(QString("%1 against %2 m").arg(error).arg(ofFine)));
        QVERIFY2(largestDistance(finer, truth) < 0.7 * error, qPrintable(QString::number(error)));
    }

    void aStepOfItsOwnLengthIsOnePart() {
        Specimen c = evenSheet();
        SubcycledEuler integrator(c.model);
        const auto report = integrator.step(c.state, 0.5 * integrator.stepLimit(), gravity);
        QVERIFY(report);
        QCOMPARE(report->parts, 1);
    }

    void itKeepsEnergyOverThousandsOfSteps() {
        Specimen c = regionSheet();
        shake(c.state.velocities, 0.02);
        SubcycledEuler integrator(c.model);
        const auto energyNow = [&] {
            double e = cloth::energy(c.model, c.state.positions);
            for (std::size_t p = 0; p < c.model.mass.size(); ++p)
                e +=
                    c.model.mass[p] * (0.5 * squaredLength(c.state.velocities[p]) - dot(gravity, c.state.positions[p]));
            return e;
        };
        cloth::placeSlaves(c.model, c.state.velocities);
        const double before = energyNow();
        double swing = 0; // of kinetic energy
        double most = before;
        for (int i = 0; i < 120; ++i) {
            run(integrator, c.state, 1, 1.0 / 60);
            double kinetic = 0;
            for (std::size_t p = 0; p < c.model.mass.size(); ++p)
                kinetic += 0.5 * c.model.mass[p] * squaredLength(c.state.velocities[p]);
            swing = std::max(swing, kinetic);
            most = std::max(most, energyNow());
        }
        QVERIFY2(most - before < 0.05 * swing, qPrintable(QString("%1 of %2 J").arg(most - before).arg(swing)));
    }
};

TOILE_TEST(tst_SubcycledEuler)
#include "tst_SubcycledEuler.moc"
