// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Energy.h"
#include "core/dynamics/Statics.h"
#include "core/dynamics/SymplecticEuler.h"
#include "core/dynamics/Xpbd.h"
#include "tests/Suite.h"
#include "tests/dynamics/Specimen.h"

#include <QTest>
#include <limits>

using namespace toile;
using namespace toile::fixtures;
using dynamics::ParticleState;

namespace {

Specimen horizontal(const Patch& patch, const Fabric& fabric, std::vector<int> pinned) {
    Specimen c;
    if (auto report = cloth::appendPatch(c.model, patch, fabric); !report)
        qFatal("%s", toString(report.error()).c_str());
    c.model.pinned = std::move(pinned);
    for (const Vec3& p : flatPositions(patch)) c.state.positions.push_back({p.x, 0, p.y});
    c.state.velocities.resize(c.state.positions.size());
    return c;
}

Patch square(int cells) {
    return gridPatch(evenLines(0.2, cells), evenLines(0.2, cells));
}

/// Pulls one particle to a place in every substep.
struct Hand : dynamics::Stage {
    int particle = 0;
    Vec3 place;
    std::string_view name() const override { return "hand"; }
    std::size_t bytes() const override { return sizeof *this; }
    void beginStep(const ParticleState&, double) override {}
    void project(dynamics::Substep& substep) override { substep.positions[particle] = place; }
    void beginIteration(std::span<const Vec3>) override {}
    double energy(std::span<const Vec3> x) const override {
        return 0.5 * stiffness * squaredLength(x[particle] - place);
    }
    void addForces(std::span<const Vec3> x, std::span<Vec3> forces) const override {
        forces[particle] -= stiffness * (x[particle] - place);
    }
    void addHessian(std::span<const Vec3>, dynamics::HessianSink& sink) const override {
        sink.add(particle, particle, {stiffness, 0, 0, 0, stiffness, 0, 0, 0, stiffness});
    }
    double stiffness = 50; ///< [N/m]
};

} // namespace

class tst_Xpbd : public QObject {
    Q_OBJECT

private slots:
    /// A weight on a spring far stiffer than its substeps allow: it sinks by g h², with inertia s by g h²/s.
    void inertiaLetsASpringBeStiffAndLeavesTheWeight() {
        const double h = 1.0 / 600, mass = 1e-4;
        cloth::ClothModel model;
        model.mass = {mass, mass};
        model.pinned = {0};
        model.structural = {{0, 1, 0.1, 1e6}};
        const auto sunkBy = [&](std::vector<double> inertia) {
            ParticleState state{{{0, 0.1, 0}, {}}, std::vector<Vec3>(2), 0};
            dynamics::Xpbd xpbd(model, {.damping = 50}, std::move(inertia));
            for (int frame = 0; frame < 60; ++frame)
                if (!xpbd.step(state, 10 * h, 10, {0, -9.81, 0}, {})) qFatal("no step");
            return -state.positions[1].y;
        };
        const double own = 9.81 * h * h;
        QVERIFY(std::abs(sunkBy({}) / own - 1) < 0.01);
        QVERIFY(std::abs(sunkBy({1, 1}) / own - 1) < 0.01);
        QVERIFY(std::abs(sunkBy({1, 50}) / (own / 50) - 1) < 0.01);
        model.structural[0].stiffness = 1; // softer than the cap: it hangs by its weight, whatever its inertia
        const double stretched = mass * 9.81 / 1;
        QVERIFY(std::abs(sunkBy({}) / stretched - 1) < 0.01);
        QVERIFY(std::abs(sunkBy({1, 4}) / stretched - 1) < 0.02);
    }

    /// Σ w²/m, of the scaled masses.
    void inertiaOfMastersIsThatOfTheirSlave() {
        cloth::ClothModel model;
        model.mass = {1, 2, 0};
        model.slaves = {{2, {{0, 0.5}, {1, 0.5}}}};
        const dynamics::Xpbd own(model, {}), scaled(model, {}, {10, 10, 1});
        for (int p = 0; p < 3; ++p) QVERIFY(std::abs(scaled.inverseMass()[p] * 10 / own.inverseMass()[p] - 1) < 1e-12);
    }

    void pinnedParticlesStay() {
        Specimen c = horizontal(square(6), wovenFabric(), {0, 6});
        const auto before = c.state.positions;
        dynamics::Xpbd xpbd(c.model, {});
        for (int i = 0; i < 30; ++i) QVERIFY(xpbd.step(c.state, 1.0 / 60, 10, gravity, {}));
        QCOMPARE(c.state.positions[0], before[0]);
        QCOMPARE(c.state.positions[6], before[6]);
        QVERIFY(c.state.positions[48].y < -0.05);
        QVERIFY(std::abs(c.state.time - 0.5) < 1e-12);
    }

    void aStoppedStepLeavesTheStateAsItWas() {
        Specimen c = horizontal(square(6), wovenFabric(), {0, 6});
        /// Asks for a stop in the third substep.
        struct Stopping : Hand {
            std::stop_source source;
            int substeps = 0;
            void project(dynamics::Substep&) override {
                if (++substeps == 3) source.request_stop();
            }
        } stage;
        dynamics::Stage* stages[] = {&stage};
        const ParticleState before = c.state;
        dynamics::Xpbd xpbd(c.model, {});
        const auto stopped = xpbd.step(c.state, 1.0 / 60, 10, gravity, stages, stage.source.get_token());
        QVERIFY(!stopped && stopped.error().code == ErrorCode::cancelled);
        QCOMPARE(stage.substeps, 3);
        QVERIFY(c.state.positions == before.positions && c.state.velocities == before.velocities);
        QCOMPARE(c.state.time, before.time);
    }

    void theSameStartGivesTheSameBits() {
        std::array<std::vector<Vec3>, 2> ends;
        for (auto& end : ends) {
            Specimen c = horizontal(twoRegionPatch(0.1, 4, 0.05, 2, 0.1, 4), knitFabric(), {0, 4});
            dynamics::Xpbd xpbd(c.model, {});
            for (int i = 0; i < 20; ++i) QVERIFY(xpbd.step(c.state, 1.0 / 60, 8, gravity, {}));
            end = c.state.positions;
        }
        QCOMPARE(ends[0], ends[1]);
    }

    void settlesWhereStaticsDoes_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"springs", "triangles", "knit cells", "two regions", "knit, two regions", "hinges"})
            QTest::newRow(kind) << kind;
    }
    /// XPBD and Newton share nothing but the model: with true stiffness (substeps short enough) both find one drape.
    void settlesWhereStaticsDoes() {
        QFETCH(QString, kind);
        const auto lines = evenLines(0.1, 5);
        const Patch patch = kind == "triangles"            ? trianglePatch(lines, lines)
                            : kind.endsWith("two regions") ? twoRegionPatch(0.1, 3, 0.05, 2, 0.1, 3)
                                                           : gridPatch(lines, lines);
        Fabric fabric = kind.startsWith("knit") ? knitFabric() : wovenFabric();
        fabric.warpBending = fabric.weftBending = fabric.biasBending = 2e-4; // holds itself up: one equilibrium
        std::vector<int> pinned;
        for (int n = 0; n < static_cast<int>(patch.material.size()); ++n)
            if (patch.material[n].y < 0.026) pinned.push_back(n); // the first two rows
        Specimen c = horizontal(patch, fabric, pinned);
        if (kind == "hinges") {
            c.model.bending.clear();
            for (int i = 0; i < 5; ++i) // across the rows, as after a merge
                for (int j = 1; j < 5; ++j) {
                    const int a = j * 6 + i;
                    c.model.hinges.push_back(cloth::seamHinge({.particles = {a, a + 1, a + 6, a - 6},
                                                               .length = 0.02,
                                                               .heightC = 0.02,
                                                               .heightD = 0.02,
                                                               .bending = 2e-4,
                                                               .restAngle = 0.02}));
                }
        }
        dynamics::Xpbd xpbd(c.model, {.damping = 20});
        for (int i = 0; i < 60; ++i) QVERIFY(xpbd.step(c.state, 1.0 / 60, 60, gravity, {}));
        const auto moving = c.state.positions;
        const auto report = dynamics::solveStatic(c.model, c.state, gravity, {}, {.tolerance = 1e-6});
        QVERIFY(report && report->newton.converged);
        double droop = 0;
        for (const Vec3& x : c.state.positions) droop = std::max(droop, -x.y);
        QVERIFY(droop > 1e-4);
        QVERIFY2(report->displacementMaximum < 0.02 * droop,
                 qPrintable(QString("%1 of %2").arg(report->displacementMaximum).arg(droop)));
    }

    void slavesStayOnTheirMasters() {
        Specimen c = horizontal(twoRegionPatch(0.1, 4, 0.05, 2, 0.1, 4), wovenFabric(), {0, 4});
        dynamics::Xpbd xpbd(c.model, {});
        for (int i = 0; i < 20; ++i) QVERIFY(xpbd.step(c.state, 1.0 / 60, 10, gravity, {}));
        for (const auto& slave : c.model.slaves) {
            Vec3 place;
            for (const auto& [master, weight] : slave.masters) place += weight * c.state.positions[master];
            QVERIFY(distance(place, c.state.positions[slave.particle]) < 1e-15);
        }
    }

    void aStageThatMovesASlaveMovesItsMasters() {
        Specimen c = horizontal(twoRegionPatch(0.1, 4, 0.05, 2, 0.1, 4), wovenFabric(), {});
        Hand hand;
        hand.particle = c.model.slaves[1].particle;
        hand.place = c.state.positions[hand.particle] + Vec3{0, 0.004, 0};
        dynamics::Stage* stages[] = {&hand};
        dynamics::Xpbd xpbd(c.model, {});
        QVERIFY(xpbd.step(c.state, 1.0 / 60, 10, {}, stages));
        QVERIFY(distance(c.state.positions[hand.particle], hand.place) < 1e-12);
        for (const auto& [master, weight] : c.model.slaves[1].masters) QVERIFY(c.state.positions[master].y > 0.001);
    }

    void staticsFollowTheForcesOfAStage() {
        Specimen c = horizontal(square(4), wovenFabric(), {0, 4});
        Hand hand;
        hand.particle = 22;
        hand.place = {0.1, 0.05, 0.2};
        dynamics::Stage* stages[] = {&hand};
        const auto report = dynamics::solveStatic(c.model, c.state, gravity, stages);
        QVERIFY(report && report->newton.converged);
        QVERIFY(distance(c.state.positions[22], hand.place) < 0.01); // half the weight on 50 N/m: 1 mm
    }

    void stiffClothGainsNoEnergyUnderTheCap() {
        Fabric stiff = wovenFabric();
        stiff.warpStiffness = stiff.weftStiffness = 5e7;
        stiff.shearStiffness = 5e6;
        for (int substeps : {10, 40, 160}) {
            Specimen c = horizontal(square(8), stiff, {0, 8});
            dynamics::Xpbd xpbd(c.model, {.damping = 0});
            dynamics::EnergyMonitor monitor;
            for (int i = 0; i < 40; ++i) {
                QVERIFY(xpbd.step(c.state, 1.0 / 60, substeps, gravity, {}));
                const auto now = energies(c.model, c.state, gravity);
                // The true stiffness counts what is left of each constraint a million times: leave it out here.
                QVERIFY(!monitor.observe({.kinetic = now.kinetic, .gravity = now.gravity}));
            }
        }
    }

    void theMonitorSeesEnergyThatNoOnePutIn() {
        dynamics::EnergyMonitor monitor;
        QVERIFY(!monitor.observe({.kinetic = 1, .gravity = 5, .elastic = 0}));
        QVERIFY(!monitor.observe({.kinetic = 2, .gravity = 3, .elastic = 1}));
        QVERIFY(!monitor.observe({.kinetic = 3, .gravity = 3, .elastic = 1}, 1.0)); // the work of a hand
        QVERIFY(monitor.observe({.kinetic = 4, .gravity = 3, .elastic = 1}));
        QVERIFY(std::abs(monitor.growth() - 1) < 1e-12);
    }

    void aStateThatIsNoNumberIsReportedAndTakenBack() {
        Specimen c = horizontal(square(4), wovenFabric(), {});
        Hand hand;
        hand.particle = 7;
        hand.place = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
        dynamics::Stage* stages[] = {&hand};
        const auto before = c.state.positions;
        dynamics::Xpbd xpbd(c.model, {});
        const auto done = xpbd.step(c.state, 1.0 / 60, 2, gravity, stages);
        QVERIFY(!done);
        QVERIFY(done.error().text.find("particle") != std::string::npos);
        QCOMPARE(c.state.positions, before);
    }

    void particlesWithoutMassAreNamed() {
        Specimen c = horizontal(square(4), wovenFabric(), {});
        c.model.mass[3] = 0;
        const auto done = dynamics::Xpbd(c.model, {}).step(c.state, 1.0 / 60, 2, gravity, {});
        QVERIFY(!done && done.error().text == "Particle 3 has no mass.");
        QVERIFY(!dynamics::solveStatic(c.model, c.state, gravity, {}));
        c.model.pinned = {3};
        QVERIFY(dynamics::Xpbd(c.model, {}).step(c.state, 1.0 / 60, 2, gravity, {}));
    }

    void particlesInOnePlacePart() {
        ClothModel model;
        model.mass = {1, 1};
        model.structural = {{0, 1, 0.01, 100}};
        ParticleState state{.positions = {{1, 1, 1}, {1, 1, 1}}, .velocities = {{}, {}}};
        dynamics::Xpbd xpbd(model, {});
        QVERIFY(xpbd.step(state, 0.1, 50, {}, {}));
        QVERIFY(distance(state.positions[0], state.positions[1]) > 0.005);
    }

    void substepsGrowWithTheLine() {
        QCOMPARE(dynamics::substepsFor(1.0 / 60, 32, 9.81), 47); // 1.4·(1/60)·32·√(1.6·9.81/0.004) = 46.8
        QCOMPARE(dynamics::substepsFor(1.0 / 60, 32, 0), 1);
        const Specimen hung = horizontal(square(6), wovenFabric(), {0, 1, 2, 3, 4, 5, 6});
        QCOMPARE(dynamics::springsOnLongestLine(hung.model), 6);
        const Specimen lying = horizontal(square(6), wovenFabric(), {});
        QCOMPARE(dynamics::springsOnLongestLine(lying.model), 6); // corner to corner is 12
    }

    void explicitStepsBeyondTheLimitAreRefusedOrDivided() {
        Specimen c = horizontal(square(6), wovenFabric(), {0, 6});
        dynamics::SymplecticEuler strict(c.model, {.automaticSubsteps = false});
        const auto refused = strict.step(c.state, 1.0 / 60, gravity);
        QVERIFY(!refused && refused.error().text.find("limit") != std::string::npos);
        dynamics::SymplecticEuler divided(c.model, {.damping = 1});
        const double start = energies(c.model, c.state, gravity).total();
        for (int i = 0; i < 30; ++i) QVERIFY(divided.step(c.state, 1.0 / 60, gravity));
        QVERIFY(energies(c.model, c.state, gravity).total() < start);
    }

    void statesThatStopAreCancelled() {
        Specimen c = horizontal(square(6), wovenFabric(), {0, 6});
        std::stop_source source;
        source.request_stop();
        const auto before = c.state.positions;
        const auto report = dynamics::solveStatic(c.model, c.state, gravity, {}, {}, source.get_token());
        QVERIFY(!report && report.error().code == ErrorCode::cancelled);
        QCOMPARE(c.state.positions, before);
    }

    void anUnreachedToleranceIsSaidHonestly() {
        Specimen c = horizontal(square(8), wovenFabric(), {0, 8});
        const auto report = dynamics::solveStatic(c.model, c.state, gravity, {}, {.maximumIterations = 3});
        QVERIFY(report);
        QVERIFY(!report->newton.converged);
        QVERIFY(report->newton.residual > 1e-3);
        QCOMPARE(report->newton.iterations, 3);
    }

    void nothingHeldIsFoundOut() {
        Specimen c = horizontal(square(3), wovenFabric(), {});
        const auto report = dynamics::solveStatic(c.model, c.state, gravity, {}, {.maximumIterations = 20});
        QVERIFY(!report || !report->newton.converged); // it falls for ever
        for (const Vec3& x : c.state.positions) QVERIFY(isFinite(x));
    }
};

TOILE_TEST(tst_Xpbd)
#include "tst_Xpbd.moc"
