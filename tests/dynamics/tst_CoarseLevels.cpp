// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/CoarseLevels.h"
#include "core/dynamics/Energy.h"
#include "core/dynamics/Statics.h"
#include "core/dynamics/Xpbd.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"
#include "tests/dynamics/Constants.h"

#include <QTest>
#include <memory>

using namespace toile;
using namespace toile::fixtures;
using dynamics::CoarseLevels;
using dynamics::LevelMesh;
using dynamics::ParticleState;

namespace {

/// Poplin that gives 1 mm under its own weight over a metre.
Fabric poplin() {
    Fabric fabric = wovenFabric();
    fabric.warpStiffness = fabric.weftStiffness = 1000;
    fabric.shearStiffness = 100;
    return fabric;
}

LevelMesh levelMesh(const Patch& patch, const Fabric& fabric) {
    LevelMesh mesh{static_cast<int>(patch.material.size()), {}};
    for (const auto& t : patch.triangles)
        mesh.triangles.push_back(
            {.particles = t.nodes,
             .material = {patch.material[t.nodes[0]], patch.material[t.nodes[1]], patch.material[t.nodes[2]]},
             .weft = fabric.weftStiffness,
             .warp = fabric.warpStiffness,
             .shear = fabric.shearStiffness});
    return mesh;
}

/// A sheet that hangs from its upper edge, columns × rows cells, and the levels above it.
struct Hanging {
    Hanging(double width, int columns, double height, int rows, int levels, bool held = true) {
        const Fabric fabric = poplin();
        const Patch patch = gridPatch(evenLines(width, columns), evenLines(height, rows));
        if (!cloth::appendPatch(model, patch, fabric)) qFatal("no cloth");
        for (int i = 0; held && i <= columns; ++i) model.pinned.push_back(i);
        for (const Vec2& m : patch.material) state.positions.push_back({m.x, -m.y, 0});
        state.velocities.resize(state.positions.size());
        xpbd = std::make_unique<dynamics::Xpbd>(model, dynamics::XpbdSettings{.damping = held ? 5.0 : 0.0});
        if (levels == 0) return;
        std::vector<LevelMesh> coarser;
        for (int level = 1; level <= levels; ++level)
            coarser.push_back(levelMesh(
                trianglePatch(evenLines(width, std::max(1, columns >> level)), evenLines(height, rows >> level)),
                fabric));
        hierarchy = std::make_unique<CoarseLevels>(
            levelMesh(trianglePatch(evenLines(width, columns), evenLines(height, rows)), fabric), coarser, model.mass,
            xpbd->inverseMass());
        xpbd->correctBy(hierarchy.get());
    }

    [[nodiscard]] bool run(double seconds, int substeps, const Vec3& g = gravity) {
        for (int i = 0; i < std::lround(60 * seconds); ++i)
            if (!xpbd->step(state, 1.0 / 60, substeps, g, {})) return false;
        return true;
    }
    /// One correction of this shape, as the first of a step of 20 substeps from the flat sheet.
    void correct(std::vector<Vec3>& shape) {
        hierarchy->beginStep(state.positions, 1.0 / 1200, 1);
        hierarchy->correct(shape);
    }

    ClothModel model;
    ParticleState state;
    std::unique_ptr<CoarseLevels> hierarchy;
    std::unique_ptr<dynamics::Xpbd> xpbd;
};

/// Rolled about the weft to a third of a circle, sheared a little and longer by this strain.
std::vector<Vec3> rolled(const std::vector<Vec3>& flat, double strain) {
    std::vector<Vec3> shape;
    for (const Vec3& x : flat) {
        const double s = -(1 + strain) * x.y, radius = 0.5;
        shape.push_back({x.x + 0.01 * s, -radius * std::sin(s / radius), radius * (1 - std::cos(s / radius))});
    }
    return shape;
}

double farthest(const Hanging& a, const Hanging& b) {
    double most = 0;
    for (std::size_t p = 0; p < a.state.positions.size(); ++p)
        most = std::max(most, distance(a.state.positions[p], b.state.positions[p]));
    return most;
}

} // namespace

/// The hierarchy above a cloth: what it carries, and what it must not touch.
class tst_CoarseLevels : public QObject {
    Q_OBJECT

private slots:
    void displacementsThatAreLinearStaySo() {
        const Fabric fabric = poplin();
        const LevelMesh fine = levelMesh(trianglePatch(evenLines(1, 30), evenLines(1, 17)), fabric); // not nested
        const LevelMesh coarse = levelMesh(trianglePatch(evenLines(1, 7), evenLines(1, 5)), fabric);
        const auto placesOf = [](const LevelMesh& mesh) {
            std::vector<Vec2> places(mesh.particles);
            for (const auto& t : mesh.triangles)
                for (int i = 0; i < 3; ++i) places[t.particles[i]] = t.material[i];
            return places;
        };
        const auto from = placesOf(coarse), to = placesOf(fine);
        const auto carried = dynamics::prolongation(fine, coarse);
        QCOMPARE(carried.count(), fine.particles);
        for (int p = 0; p < fine.particles; ++p) {
            double sum = 0;
            Vec2 at;
            for (const auto& [particle, weight] : carried.of(p)) {
                QVERIFY(weight >= 0);
                sum += weight;
                at += weight * from[particle];
            }
            QVERIFY(std::abs(sum - 1) < 1e-12);
            QVERIFY(distance(at, to[p]) < 1e-12);
        }
    }

    void whatLiesBeyondTheBorderGoesWithIt() {
        const Fabric fabric = poplin();
        const LevelMesh coarse = levelMesh(trianglePatch(evenLines(1, 4), evenLines(1, 4)), fabric);
        const LevelMesh wide = levelMesh(trianglePatch({-0.02, 0.5, 1.03}, {-0.01, 0.5, 1}), fabric);
        const auto carried = dynamics::prolongation(wide, coarse);
        QCOMPARE(carried.of(0).size(), std::size_t(1)); // the corner
        QCOMPARE(carried.of(0)[0].particle, 0);
        QCOMPARE(carried.of(0)[0].weight, 1.0);
    }

    void aParticleSewnOfTwoPlacesTakesTheirMean() {
        const Fabric fabric = poplin();
        // Two triangles of two patches; fine particle 2 is a corner of both.
        LevelMesh mesh{5, {}};
        const std::array<Vec2, 3> corners{Vec2{0, 0}, Vec2{1, 0}, Vec2{0, 1}};
        mesh.triangles.push_back({.particles = {0, 1, 2}, .material = corners, .patch = 0});
        mesh.triangles.push_back({.particles = {3, 4, 2}, .material = corners, .patch = 1});
        LevelMesh apart = mesh;
        apart.particles = 6;
        apart.triangles[1].particles[2] = 5;
        const auto carried = dynamics::prolongation(mesh, apart);
        QCOMPARE(carried.of(2).size(), std::size_t(2));
        for (const auto& term : carried.of(2)) QCOMPARE(term.weight, 0.5);
    }

    void aLongLineHangsAsStaticsSays_data() {
        QTest::addColumn<int>("springs");
        QTest::addColumn<int>("levels");
        QTest::newRow("32 springs, a level") << 32 << 1;
        QTest::newRow("64 springs, two levels") << 64 << 2;
        QTest::newRow("128 springs, three levels") << 128 << 3;
    }
    /// At 20 substeps the transport error ½·c·g·h²·n² is 0.9 mm · c for the 16 springs that are left in a line.
    void aLongLineHangsAsStaticsSays() {
        QFETCH(int, springs);
        QFETCH(int, levels);
        Hanging without(0.0625, 8, 1, springs, 0), with(0.0625, 8, 1, springs, levels),
            statics(0.0625, 8, 1, springs, 0);
        const auto rest = dynamics::solveStatic(statics.model, statics.state, gravity, {}, {.tolerance = 1e-6});
        QVERIFY(rest && rest->newton.converged);
        QVERIFY(without.run(1.5, 20) && with.run(1.5, 20));
        const double sag = farthest(with, statics), plainSag = farthest(without, statics);
        qInfo("%d springs, 20 substeps: %.2f mm too low, with %d levels %.2f mm", springs, 1000 * plainSag, levels,
              1000 * sag);
        QVERIFY(sag < 0.002);
        QVERIFY(plainSag > 3 * sag);
        QVERIFY(springs < 128 || plainSag > 0.05);
    }

    /// Of the flap that falls while it turns about its upper edge, against 32 times the substeps.
    void aFlapFallsAsInSmallSteps() {
        const auto fallen = [](int levels, int substeps) {
            auto flap = std::make_unique<Hanging>(0.125, 8, 1, 64, levels);
            for (Vec3& x : flap->state.positions) x = {x.x, 0, -x.y};
            flap->xpbd->setSettings({.damping = 0.5});
            return flap->run(0.4, substeps) ? std::move(flap) : nullptr;
        };
        const auto reference = fallen(0, 640), without = fallen(0, 20), with = fallen(2, 20);
        QVERIFY(reference && without && with);
        const double error = farthest(*with, *reference), plainError = farthest(*without, *reference);
        qInfo("64 springs, 20 substeps, after 0.4 s: %.1f mm off, with 2 levels %.1f mm", 1000 * plainError,
              1000 * error);
        QVERIFY(3 * error < plainError);
    }

    void momentumIsKept() {
        Hanging sheet(1, 32, 1, 32, 3, false);
        const auto before = rolled(sheet.state.positions, 0.02);
        auto after = before;
        sheet.correct(after);
        Vec3 momentum, turn;
        double moved = 0;
        for (std::size_t p = 0; p < after.size(); ++p) {
            const Vec3 impulse = sheet.model.mass[p] * (after[p] - before[p]);
            momentum += impulse;
            turn += cross(before[p] - Vec3{0.5, -0.5, 0}, impulse);
            moved += length(impulse);
        }
        QVERIFY2(moved > 1e-4 * 0.2, qPrintable(QString::number(moved))); // a hundredth of a millimetre in the mean
        QVERIFY2(length(momentum) < 1e-12 * moved, qPrintable(QString::number(length(momentum) / moved)));
        // Each pull turns nothing where it acts, but the sweep has moved particles by then: second order in the strain.
        QVERIFY2(length(turn) < 2e-3 * moved, qPrintable(QString::number(length(turn) / moved)));
    }

    void noEnergyComesFromNowhere() {
        for (const int levels : {1, 3}) {
            Hanging flap(1, 32, 1, 32, levels);
            for (Vec3& x : flap.state.positions) x = {x.x, 0, x.y}; // let go level
            flap.xpbd->setSettings({.damping = 0});
            dynamics::EnergyMonitor monitor;
            for (int i = 0; i < 40; ++i) {
                QVERIFY(flap.run(1.0 / 60, 20));
                const auto now = energies(flap.model, flap.state, gravity);
                // The true stiffness counts what is left of each constraint many times: leave it out here.
                QVERIFY(!monitor.observe({.kinetic = now.kinetic, .gravity = now.gravity}));
            }
        }
    }

    void foldsAreLeftAlone() {
        Hanging sheet(1, 32, 1, 32, 2, false);
        auto folded = sheet.state.positions;
        for (Vec3& x : folded) x.y *= 0.8;
        const auto before = folded;
        sheet.hierarchy->beginStep(folded, 1.0 / 1200, 1);
        sheet.hierarchy->correct(folded);
        for (std::size_t p = 0; p < folded.size(); ++p) QVERIFY(distance(folded[p], before[p]) < 1e-12);
    }

    /// Where the finest level can be as stiff as the cloth is nothing is missing, and nothing may be added.
    void clothThatIsSoftEnoughIsLeftAlone() {
        Hanging sheet(1, 16, 1, 16, 2, false);
        auto stretched = sheet.state.positions;
        for (Vec3& x : stretched) x.y *= 1.05;
        const auto before = stretched;
        sheet.hierarchy->beginStep(sheet.state.positions, 1e-5, 1);
        sheet.hierarchy->correct(stretched);
        QCOMPARE(stretched, before);
    }

    void pinnedParticlesStay() {
        Hanging sheet(1, 32, 1, 32, 3);
        const auto before = sheet.state.positions;
        QVERIFY(sheet.run(0.2, 10));
        for (const int p : sheet.model.pinned) QCOMPARE(sheet.state.positions[p], before[p]);
        QVERIFY(sheet.state.positions.back().y < before.back().y);
    }

    void theSameStartGivesTheSameBits() {
        Hanging a(1, 16, 1, 16, 2), b(1, 16, 1, 16, 2);
        QVERIFY(a.run(0.3, 10) && b.run(0.3, 10));
        QCOMPARE(a.state.positions, b.state.positions);
    }
};

TOILE_TEST(tst_CoarseLevels)
#include "tst_CoarseLevels.moc"
