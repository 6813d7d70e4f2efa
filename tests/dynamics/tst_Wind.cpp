// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Wind.h"
#include "tests/Suite.h"

#include "core/dynamics/Energy.h"
#include "core/dynamics/Method.h"
#include "core/dynamics/Statics.h"
#include "tests/dynamics/AirWorld.h"

using namespace toile;
using namespace toile::fixtures;
using dynamics::Method;
using dynamics::ParticleState;
using dynamics::Wind;

namespace {

constexpr double side = 0.2, drag = 1.2, density = 1.2; // of a sheet [m]; what WindSettings says

struct WindySheet {
    Patch patch;
    ClothModel model;
    ParticleState state;
};

/// Right side up, of woven cloth.
WindySheet levelSheet(const Patch& patch = gridPatch(evenLines(side, 5), evenLines(side, 5))) {
    WindySheet s{patch, modelOf(patch, wovenFabric()), {}};
    for (const Vec2& m : patch.material) s.state.positions.push_back({m.x, 0, -m.y});
    s.state.velocities.resize(s.state.positions.size());
    return s;
}

Wind windOn(const WindySheet& s, const Vec3& velocity) {
    return {s.model, facesOf(s.patch, wovenFabric().arealDensity), {.velocity = velocity}};
}

void forEveryMethod() {
    QTest::addColumn<Method>("method");
    for (const Method method : dynamics::allMethods())
        QTest::newRow(std::string(dynamics::nameOf(method)).c_str()) << method;
}

double kineticOf(const WindySheet& s) {
    return energies(s.model, s.state, {}).kinetic;
}

} // namespace

class tst_Wind : public QObject {
    Q_OBJECT

private slots:
    void aSheetAtRestFeelsDragOfItsAreaAcross_data() {
        QTest::addColumn<Vec3>("wind");
        QTest::addColumn<double>("upwards"); // of n [m/s]
        QTest::newRow("from below") << Vec3{0, 5, 0} << 5.0;
        QTest::newRow("from above: both sides are alike") << Vec3{0, -5, 0} << -5.0;
        QTest::newRow("edge-on") << Vec3{5, 0, 3} << 0.0;
        QTest::newRow("askew: across it alone") << Vec3{7, 3, -2} << 3.0;
        QTest::newRow("still") << Vec3{} << 0.0;
    }
    void aSheetAtRestFeelsDragOfItsAreaAcross() {
        QFETCH(Vec3, wind);
        QFETCH(double, upwards);
        for (const Patch& patch : {gridPatch(evenLines(side, 5), evenLines(side, 3)),
                                   trianglePatch(evenLines(side, 5), evenLines(side, 3))}) {
            const WindySheet s = levelSheet(patch);
            Wind stage = windOn(s, wind);
            stage.take({});
            stage.fixFriction(s.state.positions);
            const Vec3 expected{0, density * drag / 2 * side * side * upwards * std::abs(upwards), 0};
            QVERIFY(distance(sumOf(forcesOf(stage, s.state.positions)), expected) <= 1e-12);
        }
    }

    void aFallingSheetReachesItsTerminalVelocity_data() { forEveryMethod(); }
    /// m·g = ½ ρ c A v². Damping is 0; 1 s leaves of the start 1 − tanh(g·t/v), 3e-5. Subcycled Euler looks at drag
    /// when gravity has had its part of the step: it ends short of v by g·h, h = 1/60 s over the parts.
    void aFallingSheetReachesItsTerminalVelocity() {
        QFETCH(Method, method);
        WindySheet s = levelSheet();
        Wind wind = windOn(s, {});
        dynamics::Stage* stages[] = {&wind};
        const auto integrator = makeIntegrator(method, s.model, {.damping = 0, .tolerance = 1e-8});
        int parts = 0;
        for (int i = 0; i < 60; ++i) {
            const auto step = integrator->step(s.state, 1.0 / 60, {0, -9.81, 0}, stages);
            QVERIFY(step);
            parts = step->parts;
        }
        double terminal = std::sqrt(2 * wovenFabric().arealDensity * 9.81 / (density * drag));
        if (method == Method::subcycledEuler) terminal -= 9.81 / 60 / parts;
        for (const Vec3& v : s.state.velocities)
            QVERIFY2(std::abs(v.y + terminal) <= 2e-4 * terminal, qPrintable(QString::number(v.y / terminal)));
    }

    void windCarriesItAlong_data() { forEveryMethod(); }
    /// u = u₀/(1 + k·u₀·t/m): a free sheet is blown up to the wind's speed, never beyond.
    void windCarriesItAlong() {
        QFETCH(Method, method);
        WindySheet s = levelSheet();
        constexpr double speed = 6;
        Wind wind = windOn(s, {0, speed, 0});
        dynamics::Stage* stages[] = {&wind};
        const auto integrator = makeIntegrator(method, s.model, {.damping = 0, .substeps = 40, .tolerance = 1e-8});
        constexpr double duration = 0.25, step = 1.0 / 240;
        for (int i = 0; i < 60; ++i) QVERIFY(integrator->step(s.state, step, {}, stages));
        const double rate = density * drag / 2 / wovenFabric().arealDensity * speed;
        const double expected = speed - speed / (1 + rate * duration);
        const bool firstOrder = method == Method::backwardEuler || method == Method::baraffWitkin;
        for (const Vec3& v : s.state.velocities)
            QVERIFY2(std::abs(v.y - expected) <= (firstOrder ? 0.02 : 1e-3) * speed,
                     qPrintable(QString("%1 of %2").arg(v.y).arg(expected)));
    }

    void stillAirOnlyTakesEnergy_data() {
        QTest::addColumn<Method>("method");
        QTest::addColumn<double>("speed");
        for (const Method method : {Method::xpbd, Method::trBdf2, Method::backwardEuler, Method::rk4,
                                    Method::symplecticEuler, Method::subcycledEuler})
            for (const double speed : {0.1, 10.0, 1000.0})
                QTest::addRow("%s, %g m/s", std::string(dynamics::nameOf(method)).c_str(), speed) << method << speed;
    }
    /// Without elements, so that no other energy hides it; at 1000 m/s a step of 1/60 s is 60 times too long for drag.
    void stillAirOnlyTakesEnergy() {
        QFETCH(Method, method);
        QFETCH(double, speed);
        WindySheet s = levelSheet();
        ClothModel dust;
        dust.mass = s.model.mass;
        s.model = dust;
        for (Vec3& v : s.state.velocities) v = {0, speed, 0};
        shake(s.state.velocities, 0.2 * speed);
        Wind wind = windOn(s, {});
        dynamics::Stage* stages[] = {&wind};
        const auto integrator = makeIntegrator(method, s.model, {.damping = 0, .substeps = 1});
        const double start = kineticOf(s);
        for (int i = 0; i < 12; ++i) {
            const double before = kineticOf(s);
            QVERIFY(integrator->step(s.state, 1.0 / 60, {}, stages));
            // Newton's residual: 1e-4 of a weight for a step
            QVERIFY2(kineticOf(s) <= before * (1 + 1e-6), qPrintable(QString::number(kineticOf(s) / before)));
        }
        QVERIFY(kineticOf(s) < 0.99 * start);
    }

    void slavesHandTheirShareOn_data() { forEveryMethod(); }
    /// The momentum of a first short step is the force on the whole sheet, whoever bears it.
    void slavesHandTheirShareOn() {
        QFETCH(Method, method);
        WindySheet s = levelSheet(twoRegionPatch(0.1, 2, 0.1, 2, side, 4));
        QVERIFY(!s.model.slaves.empty());
        Wind wind = windOn(s, {0, 5, 0});
        dynamics::Stage* stages[] = {&wind};
        const auto integrator = makeIntegrator(method, s.model, {.damping = 0, .substeps = 1, .tolerance = 1e-10});
        constexpr double step = 1e-5;
        QVERIFY(integrator->step(s.state, step, {}, stages));
        const double expected = density * drag / 2 * 0.1 * side * 25 * step;
        QVERIFY2(std::abs(momentum(s.model, s.state).y - expected) <= 1e-3 * expected,
                 qPrintable(QString::number(momentum(s.model, s.state).y / expected)));
    }

    void forcesAreWhatDifferencesSay_data() {
        QTest::addColumn<bool>("linear");
        QTest::newRow("of the square law") << false;
        QTest::newRow("linear about given velocities") << true;
    }
    void forcesAreWhatDifferencesSay() {
        QFETCH(bool, linear);
        WindySheet s = levelSheet(gridPatch(evenLines(side, 2), evenLines(side, 2)));
        shake(s.state.positions, 0.02);
        const std::vector<Vec3> from = s.state.positions;
        shake(s.state.positions, 0.02, 3);
        Wind wind = windOn(s, {1, 2, 3});
        shake(s.state.velocities, 3);
        dynamics::Motion motion{.from = from, .span = 0.01};
        if (linear) motion.velocities = s.state.velocities;
        wind.take(motion);
        wind.fixFriction(from);
        compareWithDifferences(wind, s.state.positions);
    }

    /// A sheet that hangs by its upper edge in a light wind: statics and time find the same place, as far as a force of
    /// 2e-3 of its weight moves it, which statics leaves.
    void staticsFindsWhereASheetComesToRest() {
        WindySheet s = levelSheet();
        for (int i = 0; i < 6; ++i) s.model.pinned.push_back(i);
        for (Vec3& x : s.state.positions) x = {x.x, x.z, 0};
        ParticleState swung = s.state;
        Wind wind = windOn(s, {0, 0, 2});
        dynamics::Stage* stages[] = {&wind};
        const auto rest = solveStatic(s.model, s.state, {0, -9.81, 0}, stages);
        QVERIFY2(rest && rest->newton.converged, qPrintable(QString::number(rest ? rest->newton.residual : -1)));
        const auto integrator = makeIntegrator(Method::backwardEuler, s.model, {.damping = 4});
        for (int i = 0; i < 300; ++i) QVERIFY(integrator->step(swung, 1.0 / 60, {0, -9.81, 0}, stages));
        QVERIFY(s.state.positions.back().z > 0.02);
        for (std::size_t p = 0; p < swung.positions.size(); ++p)
            QVERIFY2(distance(swung.positions[p], s.state.positions[p]) <= 2e-4,
                     qPrintable(QString::number(distance(swung.positions[p], s.state.positions[p]))));
    }
};

TOILE_TEST(tst_Wind)
#include "tst_Wind.moc"
