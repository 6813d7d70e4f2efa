// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/Energy.h"
#include "core/dynamics/Method.h"
#include "tests/Suite.h"
#include "tests/dynamics/Specimen.h"

#include <QTest>
#include <limits>
#include <set>

using namespace toile;
using namespace toile::fixtures;
using dynamics::Integrator;
using dynamics::Method;
using dynamics::ParticleState;

namespace {

constexpr double tight = 1e-10; ///< tolerance of Newton where the method itself is looked at

/// A horizontal square of 0.2 m; pinned: by particle.
Specimen sheet(std::vector<int> pinned, const Patch& patch = gridPatch(evenLines(0.2, 5), evenLines(0.2, 5))) {
    Specimen c{modelOf(patch, wovenFabric()), {}};
    c.model.pinned = std::move(pinned);
    c.state.positions.resize(patch.material.size());
    for (std::size_t n = 0; n < patch.material.size(); ++n)
        c.state.positions[patch.particles[n]] = {patch.material[n].x, 0, patch.material[n].y};
    c.state.velocities.resize(c.state.positions.size());
    return c;
}

Specimen oneParticle() {
    Specimen c;
    c.model.mass = {0.01};
    c.state = {.positions = {{0, 10, 0}}, .velocities = {{}}};
    return c;
}

/// A method, and the tolerance of its positions if its steps are adapted.
struct Way {
    Method method = Method::xpbd;
    double positionTolerance = 0;
};

std::unique_ptr<Integrator> made(const Way& way, const ClothModel& model, dynamics::IntegratorSettings settings) {
    settings.positionTolerance = way.positionTolerance;
    return dynamics::makeIntegrator(way.method, model, settings);
}

bool isFirstOrder(Method method) {
    return method == Method::xpbd || method == Method::symplecticEuler || method == Method::subcycledEuler ||
           method == Method::backwardEuler || method == Method::baraffWitkin;
}

} // namespace

/// What every method promises (Integrator.h).
class tst_Integrators : public QObject {
    Q_OBJECT

private:
    static void everyMethod() {
        QTest::addColumn<Way>("way");
        for (const Method method : dynamics::allMethods())
            QTest::newRow(std::string(dynamics::nameOf(method)).c_str()) << Way{method};
        QTest::newRow("trbdf2, adaptive") << Way{Method::trBdf2, 1e-4};
    }

private slots:
    void namesAreUniqueAndFound() {
        std::set<std::string_view> names;
        for (const Method method : dynamics::allMethods()) {
            QVERIFY(names.insert(dynamics::nameOf(method)).second);
            QVERIFY(dynamics::methodNamed(dynamics::nameOf(method)) == method);
            const Specimen c = oneParticle();
            QVERIFY(dynamics::makeIntegrator(method, c.model, {})->name() == dynamics::nameOf(method));
        }
        QVERIFY(!dynamics::methodNamed("leapfrog"));
    }

    void momentumIsKept_data() { everyMethod(); }
    void momentumIsKept() {
        QFETCH(Way, way);
        Specimen c = sheet({});
        shake(c.state.velocities, 1);
        const auto integrator = made(way, c.model, {.damping = 0, .tolerance = tight});
        const Vec3 before = momentum(c.model, c.state);
        double scale = 0;
        for (std::size_t p = 0; p < c.model.mass.size(); ++p) scale += c.model.mass[p] * length(c.state.velocities[p]);
        run(*integrator, c.state, 10, 1.0 / 120, {});
        // explicit: rounding; implicit: what Newton leaves of the forces, 1e-10 of a weight for a twelfth of
        // a second
        QVERIFY2(length(momentum(c.model, c.state) - before) <= 1e-9 * scale,
                 qPrintable(QString::number(length(momentum(c.model, c.state) - before) / scale)));
    }

    void whatRestsStaysAtRest_data() { everyMethod(); }
    void whatRestsStaysAtRest() {
        QFETCH(Way, way);
        Specimen c = sheet({});
        const auto integrator = made(way, c.model, {});
        const auto before = c.state.positions;
        run(*integrator, c.state, 60, 1.0 / 60, {});
        for (std::size_t p = 0; p < before.size(); ++p) {
            QVERIFY(distance(before[p], c.state.positions[p]) <= 1e-12);
            QVERIFY(length(c.state.velocities[p]) <= 1e-10);
        }
        QCOMPARE(c.state.time, 1.0);
    }

    void pinsStay_data() { everyMethod(); }
    void pinsStay() {
        QFETCH(Way, way);
        Specimen c = sheet({0, 5});
        c.state.velocities[5] = {1, 2, 3}; // even if someone says they move
        const auto before = c.state.positions;
        const auto integrator = made(way, c.model, {});
        run(*integrator, c.state, 10, 1.0 / 60);
        for (int pin : c.model.pinned) {
            QCOMPARE(c.state.positions[pin], before[pin]);
            QCOMPARE(c.state.velocities[pin], Vec3{});
        }
        QVERIFY(c.state.positions[30].y < before[30].y - 0.01);
    }

    void slavesFollowTheirMasters_data() { everyMethod(); }
    void slavesFollowTheirMasters() {
        QFETCH(Way, way);
        Specimen c = sheet({0, 2}, twoRegionPatch(0.1, 2, 0.1, 2, 0.2, 4));
        QVERIFY(!c.model.slaves.empty());
        const auto integrator = made(way, c.model, {});
        run(*integrator, c.state, 10, 1.0 / 60);
        std::vector<Vec3> positions = c.state.positions, velocities = c.state.velocities;
        cloth::placeSlaves(c.model, positions);
        cloth::placeSlaves(c.model, velocities);
        for (std::size_t p = 0; p < positions.size(); ++p) {
            QVERIFY(distance(positions[p], c.state.positions[p]) <= 1e-14);
            QVERIFY(distance(velocities[p], c.state.velocities[p]) <= 1e-10);
        }
    }

    void equalStartsGiveEqualBits_data() { everyMethod(); }
    void equalStartsGiveEqualBits() {
        QFETCH(Way, way);
        const Specimen start = sheet({0, 5});
        ParticleState ends[2];
        for (ParticleState& end : ends) {
            Specimen c = start;
            const auto integrator = made(way, c.model, {});
            run(*integrator, c.state, 6, 1.0 / 60);
            end = c.state;
        }
        QCOMPARE(ends[0].positions, ends[1].positions);
        QCOMPARE(ends[0].velocities, ends[1].velocities);
    }

    void freeFallIsExactOrToItsOrder_data() { everyMethod(); }
    void freeFallIsExactOrToItsOrder() {
        QFETCH(Way, way);
        Specimen c = oneParticle();
        constexpr double h = 1.0 / 60;
        constexpr int n = 60;
        const auto integrator = made(way, c.model, {.damping = 0, .substeps = 1, .tolerance = tight});
        run(*integrator, c.state, n, h);
        const double depth = isFirstOrder(way.method) ? 9.81 * h * h * n * (n + 1) / 2 : 9.81 / 2;
        QVERIFY(std::abs(10 - c.state.positions[0].y - depth) <= 1e-9);
        QVERIFY(std::abs(c.state.velocities[0].y + 9.81) <= 1e-9);
    }

    void dampingTakesVelocityAway_data() { everyMethod(); }
    void dampingTakesVelocityAway() {
        QFETCH(Way, way);
        constexpr double damping = 2, time = 0.5;
        const auto errorAt = [&](int steps) {
            Specimen c = oneParticle();
            c.state.velocities[0] = {1, 0, 0};
            const auto integrator = made(way, c.model, {.damping = damping, .substeps = 1, .tolerance = 1e-14});
            run(*integrator, c.state, steps, time / steps, {});
            return std::abs(c.state.velocities[0].x - std::exp(-damping * time));
        };
        const double coarse = errorAt(16), fine = errorAt(32); // αh = 1/16, 1/32
        QVERIFY(coarse <= (isFirstOrder(way.method) ? 0.02 : 1e-3));
        QVERIFY(fine <= (isFirstOrder(way.method) ? 0.55 : 0.3) * coarse);
    }

    void durationsThatCannotBeMadeAreRefused_data() { everyMethod(); }
    void durationsThatCannotBeMadeAreRefused() {
        QFETCH(Way, way);
        Specimen c = sheet({0});
        const auto integrator = made(way, c.model, {});
        for (const double duration :
             {0.0, -0.01, 1e9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
            const auto before = c.state.positions;
            const auto refused = integrator->step(c.state, duration, gravity);
            QVERIFY(!refused && refused.error().code == ErrorCode::invalidInput);
            QVERIFY(refused.error().text.find("step") != std::string::npos);
            QCOMPARE(c.state.positions, before);
        }
    }

    void whatIsNoNumberIsNotLetIn_data() { everyMethod(); }
    void whatIsNoNumberIsNotLetIn() {
        QFETCH(Way, way);
        const Specimen sound = sheet({0});
        const auto integrator = made(way, sound.model, {});
        const double nan = std::numeric_limits<double>::quiet_NaN();
        ParticleState place = sound.state, speed = sound.state;
        place.positions[7].z = nan;
        speed.velocities[7].x = std::numeric_limits<double>::infinity();
        for (ParticleState* state : {&place, &speed}) {
            const auto refused = integrator->step(*state, 1.0 / 60, gravity);
            QVERIFY(!refused && refused.error().text.find("article 7") != std::string::npos);
            QCOMPARE(state->time, 0.0);
        }
    }

    void forcesThatAreNoNumberDoNotComeOut_data() { everyMethod(); }
    void forcesThatAreNoNumberDoNotComeOut() {
        QFETCH(Way, way);
        Specimen c = sheet({0});
        const auto before = c.state.positions;
        const auto integrator = made(way, c.model, {});
        const auto refused = integrator->step(c.state, 1.0 / 60, {0, std::numeric_limits<double>::quiet_NaN(), 0});
        QVERIFY(!refused && refused.error().code == ErrorCode::notConverged);
        QCOMPARE(c.state.positions, before);
    }

    void aParticleWithoutMassIsNamed_data() { everyMethod(); }
    void aParticleWithoutMassIsNamed() {
        QFETCH(Way, way);
        Specimen c = sheet({0});
        c.model.mass[3] = 0;
        const auto integrator = made(way, c.model, {});
        const auto refused = integrator->step(c.state, 1.0 / 60, gravity);
        QVERIFY(!refused && refused.error().text.find("3") != std::string::npos);
    }

    void aStopIsAnswered_data() { everyMethod(); }
    void aStopIsAnswered() {
        QFETCH(Way, way);
        Specimen c = sheet({0});
        const auto integrator = made(way, c.model, {});
        std::stop_source source;
        source.request_stop();
        const auto stopped = integrator->step(c.state, 1.0 / 60, gravity, {}, source.get_token());
        QVERIFY(!stopped && stopped.error().code == ErrorCode::cancelled);
        QCOMPARE(c.state.time, 0.0);
    }

    /// Where the step is far too long for the sheet's own waves. The midpoint rule and SDIRK4 do not promise
    /// it; what XPBD sags is energy at the true stiffness.
    void aFallingSheetGainsNoEnergy_data() {
        QTest::addColumn<Way>("way");
        QTest::newRow("trbdf2, adaptive") << Way{Method::trBdf2, 1e-4};
        for (const Method method : {Method::trBdf2, Method::backwardEuler, Method::bdf2, Method::baraffWitkin,
                                    Method::rk4, Method::symplecticEuler})
            QTest::newRow(std::string(dynamics::nameOf(method)).c_str()) << Way{method};
    }
    void aFallingSheetGainsNoEnergy() {
        QFETCH(Way, way);
        Specimen c = sheet({0, 5});
        const auto integrator = made(way, c.model, {});
        const double start = energies(c.model, c.state, gravity).total();
        double most = start, turned = 0;
        for (int i = 0; i < 60; ++i) {
            run(*integrator, c.state, 1, 1.0 / 60);
            const auto now = energies(c.model, c.state, gravity);
            most = std::max(most, now.total());
            turned = std::max(turned, std::abs(now.gravity));
        }
        QVERIFY(most - start <= 0.01 * turned);
    }
};

TOILE_TEST(tst_Integrators)
#include "tst_Integrators.moc"
