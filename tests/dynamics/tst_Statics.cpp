// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/collision/BodySurface.h"
#include "core/dynamics/BodyContact.h"
#include "core/dynamics/Method.h"
#include "core/dynamics/Statics.h"
#include "core/dynamics/Xpbd.h"
#include "tests/Suite.h"
#include "tests/dynamics/IdleStage.h"
#include "tests/dynamics/Specimen.h"

#include <QTest>
#include <limits>
#include <numbers>

using namespace toile;
using namespace toile::fixtures;

namespace {

/// A horizontal square sheet of `cells`² cells and side `size`, its corners at −x pinned.
Specimen heldSheet(const Fabric& fabric, double size, int cells, bool triangles = false) {
    Specimen s;
    const auto lines = evenLines(size, cells);
    const Patch patch = triangles ? trianglePatch(lines, lines) : gridPatch(lines, lines);
    auto report = cloth::appendPatch(s.model, patch, fabric);
    if (!report) qFatal("%s", toString(report.error()).c_str());
    for (const Vec2& m : patch.material) s.state.positions.push_back({m.x, 0, m.y});
    s.state.velocities.resize(s.state.positions.size());
    s.model.pinned = {0, cells * (cells + 1)};
    return s;
}

/// A ball about the origin, 2n meridians and n bands.
geometry::TriangleMesh ball(double radius, int n) {
    geometry::TriangleMesh mesh;
    const auto ring = [&](int band, int meridian) { return band * 2 * n + meridian % (2 * n); };
    for (int band = 0; band <= n; ++band)
        for (int m = 0; m < 2 * n; ++m) {
            const double a = std::numbers::pi * band / n, b = std::numbers::pi * m / n;
            mesh.vertices.push_back(
                {radius * std::sin(a) * std::cos(b), radius * std::cos(a), radius * std::sin(a) * std::sin(b)});
        }
    for (int band = 0; band < n; ++band)
        for (int m = 0; m < 2 * n; ++m) {
            mesh.triangles.push_back({ring(band, m), ring(band, m + 1), ring(band + 1, m + 1)});
            mesh.triangles.push_back({ring(band, m), ring(band + 1, m + 1), ring(band + 1, m)});
        }
    return geometry::welded(mesh, 1e-9);
}

/// Pulls particle 0 up and down: a spring to y = 0, and beside it a push of its own that answers, each time that
/// friction is fixed, one and a half times as strongly as the spring, as friction may that cloth slides on.
struct Answering final : dynamics::IdleStage {
    static constexpr double stiffness = 1, answer = 1.5 * stiffness, load = 0.01; // [N/m], [N]
    explicit Answering(bool canEase) : eases(canEase) {}

    void fixFriction(std::span<const Vec3> x) override {
        before = push;
        push = load - answer * x[0].y;
    }
    void easeFriction(double part) override {
        if (eases) push = std::lerp(before, push, part);
    }
    [[nodiscard]] double energy(std::span<const Vec3> x) const override {
        return 0.5 * stiffness * squaredLength(x[0]) - push * x[0].y;
    }
    void addForces(std::span<const Vec3> x, std::span<Vec3> forces) const override {
        forces[0] += Vec3{0, push, 0} - stiffness * x[0];
    }
    void addHessian(std::span<const Vec3>, dynamics::HessianSink& sink) const override {
        const double block[9] = {stiffness, 0, 0, 0, stiffness, 0, 0, 0, stiffness};
        sink.add(0, 0, block);
    }

    bool eases;
    double before = 0, push = 0; // [N]
};

/// Does nothing but count what is asked of it, and ask for a stop at one of these questions.
struct Stopper : dynamics::Stage {
    enum class Question { energy, hessian };
    Question which = Question::energy;
    int stopAt = 0;
    mutable std::stop_source source;
    mutable int asked = 0;                            ///< of the kind that matters
    mutable int energiesLater = 0, hessiansLater = 0; ///< after the stop

    void count(Question question) const {
        if (source.stop_requested()) ++(question == Question::energy ? energiesLater : hessiansLater);
        else if (question == which && ++asked == stopAt) source.request_stop();
    }
    std::string_view name() const override { return "stopper"; }
    std::size_t bytes() const override { return sizeof *this; }
    void beginStep(const dynamics::ParticleState&, double) override {}
    void project(dynamics::Substep&) override {}
    void beginIteration(std::span<const Vec3>) override {}
    double energy(std::span<const Vec3>) const override {
        count(Question::energy);
        return 0;
    }
    void addForces(std::span<const Vec3>, std::span<Vec3>) const override {}
    void addHessian(std::span<const Vec3>, dynamics::HessianSink&) const override { count(Question::hessian); }
};

double residualOf(const Specimen& s) {
    std::vector<Vec3> forces(s.state.positions.size());
    cloth::addForces(s.model, s.state.positions, forces);
    cloth::gatherToMasters(s.model, forces);
    double worst = 0, weight = 0;
    for (int p = 0; p < s.model.particleCount(); ++p) {
        weight += s.model.mass[p] * 9.81 / s.model.particleCount();
        if (std::ranges::find(s.model.pinned, p) == s.model.pinned.end())
            worst = std::max(worst, length(forces[p] + s.model.mass[p] * gravity));
    }
    return worst / weight;
}

} // namespace

class tst_Statics : public QObject {
    Q_OBJECT

private slots:
    void frictionThatAnswersTooStronglyIsEased() {
        for (const bool eases : {false, true}) {
            Specimen s;
            s.model.mass = {1e-3};
            s.state.positions = s.state.velocities = {{}};
            Answering stage(eases);
            dynamics::Stage* stages[]{&stage};
            const auto report = dynamics::solveStatic(s.model, s.state, {}, stages);
            QVERIFY(report);
            QCOMPARE(report->newton.converged, eases);
            const double balance = Answering::load / (Answering::stiffness + Answering::answer);
            QCOMPARE(std::abs(s.state.positions[0].y - balance) < 2e-5, eases);
        }
    }
    void aSheetOnTwoCornersComesToRestFromItsDrape_data() {
        QTest::addColumn<bool>("knit");
        QTest::addColumn<bool>("triangles");
        QTest::newRow("springs") << false << false;
        QTest::newRow("triangles") << false << true;
        QTest::newRow("knit cells") << true << false;
    }
    void aSheetOnTwoCornersComesToRestFromItsDrape() {
        QFETCH(bool, knit);
        QFETCH(bool, triangles);
        Specimen s = heldSheet(knit ? knitFabric() : wovenFabric(), 0.5, 20, triangles);
        dynamics::Xpbd xpbd(s.model, {.damping = 3});
        for (int frame = 0; frame < 120; ++frame) QVERIFY(xpbd.step(s.state, 1.0 / 60, 20, gravity, {}));
        const auto report = dynamics::solveStatic(s.model, s.state, gravity, {});
        QVERIFY2(report, report ? "" : toString(report.error()).c_str());
        QVERIFY(report->newton.converged);
        QVERIFY(residualOf(s) <= 1e-3);
        QCOMPARE(report->newton.analyses, 1);
    }

    void aSheetOnABallComesToRestWithContactAndFriction() {
        Specimen s = heldSheet(wovenFabric(), 0.5, 20);
        s.model.pinned.clear();
        for (Vec3& x : s.state.positions) x += Vec3{-0.237, 0.16, -0.243};
        const auto body = collision::BodySurface::create(ball(0.15, 30));
        QVERIFY(body);
        const std::vector<double> halfThickness(s.model.mass.size(), 2e-4), friction(s.model.mass.size(), 0.4);
        // Ten times softer than by default: on a curved body stiff contact moves more force than the tangent planes
        // of one iteration are true for.
        dynamics::BodyContact contact(*body, dynamics::particleSamples(s.model, halfThickness, friction, 0.3),
                                      {.stiffness = 2.5e6});
        dynamics::Stage* stages[] = {&contact};
        dynamics::Xpbd xpbd(s.model, {.damping = 2});
        for (int frame = 0; frame < 240; ++frame) QVERIFY(xpbd.step(s.state, 1.0 / 60, 20, gravity, stages));
        const auto report = dynamics::solveStatic(s.model, s.state, gravity, stages);
        QVERIFY(report);
        QVERIFY2(report->newton.converged, qPrintable(QString("residual %1").arg(report->newton.residual)));
        QVERIFY(contact.clearance(s.state.positions) > 0.0025); // of 3.2 mm asked
        QVERIFY(contact.report(s.state.positions).contacts > 20);
    }

    void aStopEndsWhatIsUnderWayAndNothingElse_data() {
        QTest::addColumn<int>("cells");
        QTest::addColumn<Stopper::Question>("which");
        QTest::addColumn<int>("stopAt");
        for (const int cells : {16, 64}) // few particles, and so many that they have steps of their own
            for (const int stopAt : {1, 2, 3, 4, 7, 10, 15}) {
                QTest::addRow("%d cells, energy %d", cells, stopAt) << cells << Stopper::Question::energy << stopAt;
                QTest::addRow("%d cells, Hessian %d", cells, stopAt) << cells << Stopper::Question::hessian << stopAt;
            }
    }
    void aStopEndsWhatIsUnderWayAndNothingElse() {
        QFETCH(int, cells);
        Specimen s = heldSheet(wovenFabric(), 0.5, cells);
        QFETCH(Stopper::Question, which);
        QFETCH(int, stopAt);
        Stopper stopper;
        stopper.which = which;
        stopper.stopAt = stopAt;
        dynamics::Stage* stages[] = {&stopper};
        const auto report = dynamics::solveStatic(s.model, s.state, gravity, stages, {}, stopper.source.get_token());
        QVERIFY(!report && report.error().code == ErrorCode::cancelled);
        QCOMPARE(stopper.hessiansLater, 0);
        QVERIFY(stopper.energiesLater <= 1); // where a step that was just taken has led
    }

    void withoutMemoryForAFactorTheSameRestIsFound_data() {
        QTest::addColumn<int>("cells");
        QTest::newRow("few particles") << 16;
        QTest::newRow("so many that they have steps of their own") << 36;
    }
    /// Both leave a thousandth of the mean particle weight at most: what is soft may lie apart by a tenth of a cell.
    void withoutMemoryForAFactorTheSameRestIsFound() {
        QFETCH(int, cells);
        Specimen s = heldSheet(wovenFabric(), 0.5, cells);
        dynamics::Xpbd xpbd(s.model, {.damping = 3});
        for (int frame = 0; frame < 120; ++frame) QVERIFY(xpbd.step(s.state, 1.0 / 60, 20, gravity, {}));
        dynamics::ParticleState within = s.state;
        const auto usual = dynamics::solveStatic(s.model, s.state, gravity, {});
        const auto report = dynamics::solveStatic(s.model, within, gravity, {}, {.factorBytes = 10'000});
        QVERIFY(usual && report);
        QVERIFY(usual->newton.converged && usual->newton.refusedFactor == 0 && usual->newton.factorizations > 0);
        QVERIFY(report->newton.refusedFactor > 10'000);
        QCOMPARE(report->newton.factorizations, 0);
        QVERIFY2(report->newton.converged, qPrintable(QString("residual %1").arg(report->newton.residual)));
        double farthest = 0;
        for (std::size_t p = 0; p < within.positions.size(); ++p)
            farthest = std::max(farthest, distance(within.positions[p], s.state.positions[p]));
        QVERIFY2(farthest < 0.1 * 0.5 / cells, qPrintable(QString("%1 m").arg(farthest)));
    }

    void aFactorThatFitsIsMadeUpToTheLastByte() {
        Specimen s = heldSheet(wovenFabric(), 0.5, 16);
        dynamics::ParticleState another = s.state, third = s.state;
        const auto refused = dynamics::solveStatic(s.model, s.state, gravity, {}, {.factorBytes = 0});
        QVERIFY(refused && refused->newton.refusedFactor > 0);
        const std::size_t needed = refused->newton.refusedFactor;
        const auto fits = dynamics::solveStatic(s.model, another, gravity, {}, {.factorBytes = needed});
        const auto doesNot = dynamics::solveStatic(s.model, third, gravity, {}, {.factorBytes = needed - 1});
        QVERIFY(fits && fits->newton.refusedFactor == 0 && fits->newton.factorizations > 0);
        QVERIFY(doesNot && doesNot->newton.refusedFactor == needed && doesNot->newton.factorizations == 0);
    }

    void stepsInTimeGoOnWithoutAFactor_data() {
        QTest::addColumn<dynamics::Method>("method");
        for (const auto method : {dynamics::Method::backwardEuler, dynamics::Method::trBdf2, dynamics::Method::bdf2,
                                  dynamics::Method::baraffWitkin})
            QTest::newRow(dynamics::nameOf(method).data()) << method;
    }
    /// Conjugate gradients that may take none before the factor takes over always ask for it.
    void stepsInTimeGoOnWithoutAFactor() {
        QFETCH(dynamics::Method, method);
        Specimen s = heldSheet(wovenFabric(), 0.5, 16);
        dynamics::ParticleState within = s.state;
        const auto usual = dynamics::makeIntegrator(method, s.model, {.gradientIterations = 0});
        const auto bounded = dynamics::makeIntegrator(method, s.model, {.gradientIterations = 0, .factorBytes = 0});
        for (int step = 0; step < 10; ++step) {
            const auto done = usual->step(s.state, 1.0 / 120, gravity),
                       also = bounded->step(within, 1.0 / 120, gravity);
            QVERIFY(done && also);
            QVERIFY(done->refusedFactor == 0 && done->factorizations > 0);
            QVERIFY(also->refusedFactor > 0 && also->factorizations == 0 && also->gradientIterations > 0);
            QVERIFY(also->accurate);
        }
        // Each step leaves 1e-4 of the mean particle weight: in 1/12 s that moves a particle by a micrometre or two.
        for (std::size_t p = 0; p < within.positions.size(); ++p)
            QVERIFY(distance(within.positions[p], s.state.positions[p]) < 1e-5);
    }

    void aFlatSheetFallsIntoEquilibriumToo() {
        Specimen s = heldSheet(wovenFabric(), 0.5, 16);
        const auto report = dynamics::solveStatic(s.model, s.state, gravity, {});
        QVERIFY(report);
        QVERIFY(report->newton.converged);
        QVERIFY(report->displacementMaximum > 0.3);
    }
};

TOILE_TEST(tst_Statics)
#include "tst_Statics.moc"
