// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Energy.h"
#include "core/dynamics/Method.h"
#include "core/dynamics/StrainDamping.h"
#include "core/dynamics/Xpbd.h"
#include "core/study/validation/Sheets.h"
#include "tests/Suite.h"
#include "tests/dynamics/Specimen.h"

#include <QTest>
#include <random>

using namespace toile;
using namespace toile::dynamics;
using fixtures::Specimen;

namespace {

/// A sheet of 8 × 8 cells in disorder: every particle has a speed of its own.
Specimen kicked(double speed, cloth::CellForm form = cloth::CellForm::automatic) {
    cloth::Patch patch =
        study::validation::gridPatch(study::validation::evenLines(0.2, 8), study::validation::evenLines(0.2, 8));
    Specimen sheet{study::validation::modelOf(patch, study::validation::unequalWeave(), form), {}};
    std::mt19937 random(7);
    std::uniform_real_distribution<double> some(-speed, speed);
    for (int p = 0; p < sheet.model.particleCount(); ++p) {
        sheet.state.positions.push_back({0.025 * (p % 9), 0.025 * (p / 9), 0});
        sheet.state.velocities.push_back({some(random), some(random), some(random)});
    }
    return sheet;
}

std::vector<Method> damped() {
    std::vector<Method> methods(allMethods().begin(), allMethods().end());
    std::erase(methods, Method::subcycledEuler); // the paper's, which has no such damping
    return methods;
}

} // namespace

/// What the damper of one spring does is case V1 of the validation study.
class tst_StrainDamping : public QObject {
    Q_OBJECT
private slots:
    void energyGoesSoonerAndMomentumStays_data() {
        QTest::addColumn<Method>("method");
        for (const Method method : damped()) QTest::newRow(std::string(nameOf(method)).c_str()) << method;
    }
    void energyGoesSoonerAndMomentumStays() {
        QFETCH(Method, method);
        double left[2];
        for (const bool isDamped : {false, true}) {
            Specimen sheet = kicked(0.1);
            const Vec3 before = momentum(sheet.model, sheet.state);
            StrainDamping damping(sheet.model, 0.01, sheet.state.positions);
            Stage* const stages[] = {&damping};
            const auto integrator = makeIntegrator(method, sheet.model, {.damping = 0, .substeps = 10});
            for (int i = 0; i < 10; ++i) {
                const auto done = integrator->step(sheet.state, 0.002, {}, std::span(stages).first(isDamped));
                QVERIFY2(done, done ? "" : toString(done.error()).c_str());
                if (isDamped) QCOMPARE(done->repeated, 0); // what dashpots take is no energy that was gained
            }
            left[isDamped] = energies(sheet.model, sheet.state, {}).total();
            QVERIFY(length(momentum(sheet.model, sheet.state) - before) < 1e-6 * 0.1);
        }
        QVERIFY2(left[1] < 0.7 * left[0], qPrintable(QString("%1 J of %2 J").arg(left[1]).arg(left[0])));
    }

    /// However strong: in one substep no kinetic energy is won, and cloth that moves as a whole goes on.
    void aSubstepPutsNoEnergyIn() {
        for (const double time : {1e-4, 1e-2, 1e3}) {
            Specimen sheet = kicked(1);
            const double h = 1e-3;
            std::vector<Vec3> moved = sheet.state.positions;
            std::vector<double> inverseMass;
            for (const double m : sheet.model.mass) inverseMass.push_back(1 / m);
            for (std::size_t p = 0; p < moved.size(); ++p) moved[p] += h * sheet.state.velocities[p];
            StrainDamping damping(sheet.model, time, sheet.state.positions);
            Substep substep{moved, sheet.state.positions, inverseMass, h, h};
            damping.project(substep);
            double before = 0, after = 0;
            for (std::size_t p = 0; p < moved.size(); ++p) {
                before += sheet.model.mass[p] * squaredLength(sheet.state.velocities[p]);
                after += sheet.model.mass[p] * squaredLength((moved[p] - sheet.state.positions[p]) / h);
            }
            QVERIFY2(after < before, qPrintable(QString::number(after / before)));
        }
    }

    /// Nor do many, with the sweep over the cloth in between: what was kicked is nearly still after a second.
    void strongDampingIsStable_data() {
        QTest::addColumn<double>("time");
        QTest::addColumn<cloth::CellForm>("form");
        for (const double time : {0.005, 0.05, 0.5}) {
            QTest::addRow("springs, %g s", time) << time << cloth::CellForm::springs;
            QTest::addRow("membrane, %g s", time) << time << cloth::CellForm::membrane;
        }
    }
    void strongDampingIsStable() {
        QFETCH(double, time);
        QFETCH(cloth::CellForm, form);
        Specimen sheet = kicked(1, form);
        StrainDamping damping(sheet.model, time, sheet.state.positions);
        Stage* const stages[] = {&damping};
        Xpbd xpbd(sheet.model, {.damping = 0});
        const double start = energies(sheet.model, sheet.state, {}).total();
        double now = start, most = 0;
        for (int frame = 0; frame < 60; ++frame) {
            QVERIFY(xpbd.step(sheet.state, 1.0 / 60, 10, {}, stages));
            now = energies(sheet.model, sheet.state, {}).total();
            most = std::max(most, now);
        }
        QVERIFY2(most < 2 * start, qPrintable(QString("%1 J of %2 J").arg(most).arg(start)));
        QVERIFY2(now < 0.03 * start, qPrintable(QString("%1 J of %2 J").arg(now).arg(start)));
    }

    void clothThatMovesAsAWholeIsNotResisted_data() { energyGoesSoonerAndMomentumStays_data(); }
    void clothThatMovesAsAWholeIsNotResisted() {
        QFETCH(Method, method);
        Specimen sheet = kicked(0);
        for (std::size_t p = 0; p < sheet.state.positions.size(); ++p)
            sheet.state.velocities[p] = Vec3{1, 2, 3} + cross(Vec3{0, 0, 0.01}, sheet.state.positions[p]);
        const ParticleState start = sheet.state;
        StrainDamping damping(sheet.model, 0.01, sheet.state.positions);
        Stage* const stages[] = {&damping};
        const auto integrator = makeIntegrator(method, sheet.model, {.damping = 0, .substeps = 10});
        for (int i = 0; i < 5; ++i) QVERIFY(integrator->step(sheet.state, 0.002, {}, stages));
        for (std::size_t p = 0; p < start.positions.size(); ++p) {
            const Vec3 expected = start.positions[p] + 0.01 * start.velocities[p];
            QVERIFY2(geometry::distance(sheet.state.positions[p], expected) < 1e-7,
                     qPrintable(QString::number(geometry::distance(sheet.state.positions[p], expected))));
        }
    }

    void explicitStepsAreShorter() {
        const Specimen sheet = kicked(0);
        const auto integrator = makeIntegrator(Method::symplecticEuler, sheet.model, {.damping = 0});
        StrainDamping damping(sheet.model, 0.01, sheet.state.positions);
        Stage* const stages[] = {&damping};
        const double limit = integrator->stepLimit(sheet.state.positions);
        const double ratio = 0.01 / limit; // ζ = βω/2, ω = 2/limit
        const double expected = limit * (std::sqrt(1 + ratio * ratio) - ratio);
        const double found = integrator->stepLimit(sheet.state.positions, stages);
        QVERIFY2(std::abs(found - expected) < 1e-3 * expected, qPrintable(QString("%1 %2").arg(found).arg(expected)));
    }
};

TOILE_TEST(tst_StrainDamping, QCoreApplication)
#include "tst_StrainDamping.moc"
