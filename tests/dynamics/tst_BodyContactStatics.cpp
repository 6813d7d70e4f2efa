// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Method.h"
#include "core/dynamics/Statics.h"
#include "core/dynamics/Xpbd.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"
#include "tests/dynamics/ContactWorld.h"
#include "tests/dynamics/DenseSink.h"

#include <QTest>
#include <array>

using namespace toile;
using namespace toile::contactWorld;
using fixtures::DenseSink;

namespace {

/// At the soft beginning, where pushes are stiffer the farther in, and in the body [m].
constexpr std::array dents{2e-4, 1.5e-3, 2.5e-3, 5e-3};

/// vᵀHv and the change of the forces along a random v, for two samples and the one between them, which start at a
/// distance from the middle of a round body, dented by so much along it, and then move a little.
std::pair<double, double> alongARandomWay(const collision::BodySurface& body, double radius, double dent,
                                          std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1, 1);
    const Vec3 up = normalized(shapes::randomPoint(random, 1));
    std::vector<Vec3> x{up * (radius + dent), up * (radius + dent) + shapes::randomPoint(random, 1e-4)};
    std::vector<ContactSample> samples{sampleAt(0, 0.3), sampleAt(1, 0.3)};
    samples.push_back(dynamics::middleOf(std::array<const ContactSample*, 2>{&samples[0], &samples[1]}));
    BodyContact contact(body, samples);
    contact.take({});
    contact.fixFriction(x);
    contact.beginIteration(x);
    const double way = any(random) > 0 ? 4e-5 : 2e-4; // sticking and slipping
    for (Vec3& p : x) p += shapes::randomPoint(random, way);
    DenseSink sink(2);
    contact.addHessian(x, sink);

    std::vector<double> v(6);
    for (double& value : v) value = any(random);
    const double step = 1e-8;
    auto more = x, less = x;
    for (int k = 0; k < 6; ++k) {
        more[k / 3][k % 3] += step * v[k];
        less[k / 3][k % 3] -= step * v[k];
    }
    std::vector<Vec3> forceMore(2), forceLess(2);
    contact.addForces(more, forceMore);
    contact.addForces(less, forceLess);
    double curvature = 0;
    for (int k = 0; k < 6; ++k) curvature -= v[k] * (forceMore[k / 3][k % 3] - forceLess[k / 3][k % 3]) / (2 * step);
    return {sink.quadratic(v), curvature};
}

} // namespace

class tst_BodyContactStatics : public QObject {
    Q_OBJECT
private slots:
    void theForceIsMinusTheGradientOfTheEnergy();
    void theHessianIsNeverNegativeAndOnRoundPartsNoLessThanTheCurvature();
    void inAHollowTheHessianIsTheCurvatureOfTheEnergy();
    void inStaticsFrictionHoldsUpToTheConeAndNotBeyond();
    void frictionGoesPartOfTheWayToTheForcesOfHere();
    void aSheetDrapesOverABallAndStaysOutsideInStatics();
    void whatPressesHardRestsAtItsDistance_data();
    void whatPressesHardRestsAtItsDistance();
    void explicitStepsAreAsStiffAsTheirLimitKnows();
    void whatIsRecalledGoesOnAsItWas();
    void anotherContactGoesOnAsFarAsItsSamplesAreTheSame();
    void inAGrooveAParticleComesToRest();
};

void tst_BodyContactStatics::theForceIsMinusTheGradientOfTheEnergy() {
    const auto body = surfaceOf(shapes::starBody(30, 40, [](const Vec3&) { return 0.1; }));
    std::mt19937 random(23);
    for (int n = 0; n < 80; ++n) {
        const Vec3 up = normalized(shapes::randomPoint(random, 1)),
                   start = up * (0.1 + target - dents[n / 2 % dents.size()]);
        std::vector<Vec3> x{start, start + shapes::randomPoint(random, 0.01)};
        std::vector<ContactSample> samples{sampleAt(0, 0.3), sampleAt(1, 0.3)};
        samples.push_back(dynamics::middleOf(std::array<const ContactSample*, 2>{&samples[0], &samples[1]}));
        BodyContact contact(body, samples);
        contact.take({});
        contact.fixFriction(x);
        contact.beginIteration(x);
        for (Vec3& p : x) p += shapes::randomPoint(random, n % 2 ? 1e-4 : 1e-3); // sticking and slipping
        std::vector<Vec3> forces(2);
        contact.addForces(x, forces);
        for (int i = 0; i < 2; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                const double step = 1e-8;
                auto more = x, less = x;
                more[i][axis] += step;
                less[i][axis] -= step;
                const double slope = (contact.energy(more) - contact.energy(less)) / (2 * step);
                // k = 500 N/m over 10 nm, and a kink of the curvature where contact begins
                QVERIFY(std::abs(forces[i][axis] + slope) < 1e-5 * (std::abs(slope) + 0.1));
            }
    }
}

void tst_BodyContactStatics::theHessianIsNeverNegativeAndOnRoundPartsNoLessThanTheCurvature() {
    const auto ball = surfaceOf(shapes::starBody(30, 40, [](const Vec3&) { return 0.1; }));
    std::mt19937 random(24);
    for (int n = 0; n < 40; ++n) {
        const auto [quadratic, curvature] = alongARandomWay(ball, 0.1 + target, -dents[n % dents.size()], random);
        QVERIFY(quadratic >= -1e-9);
        QVERIFY(quadratic >= curvature - 1e-4 * (1 + std::abs(curvature)));
    }
}

void tst_BodyContactStatics::inAHollowTheHessianIsTheCurvatureOfTheEnergy() {
    auto turned = shapes::starBody(60, 80, [](const Vec3&) { return 0.1; });
    for (auto& [a, b, c] : turned.triangles) std::swap(b, c);
    const auto hollow = surfaceOf(std::move(turned));
    std::mt19937 random(25);
    for (int n = 0; n < 40; ++n) {
        const double dent = dents[n % dents.size()];
        const auto [quadratic, curvature] = alongARandomWay(hollow, 0.1 - target, dent, random);
        QVERIFY(quadratic >= -1e-9);
        // what little is round, at the corners of a ball of triangles, is left out, more the harder it presses
        QVERIFY(std::abs(quadratic - curvature) < (dent < 1e-3 ? 1e-3 : 2e-3) * (1 + std::abs(curvature)));
    }
}

void tst_BodyContactStatics::inStaticsFrictionHoldsUpToTheConeAndNotBeyond() {
    const auto plane = surfaceOf(shapes::plane(1, 8));
    const double mu = 0.3, mass = 2e-5, weight = mass * freeFall;
    for (const double angle : {10.0, 16.0, 17.4, 25.0}) {
        World world({{0, target, 0}});
        world.acceleration = slope(angle * degrees);
        BodyContact contact(plane, {sampleAt(0, mu)});
        world.run(contact, 0.05); // the normal force is known from the substeps
        std::vector<Vec3> x = world.positions;
        const Vec3 start = x[0];
        double residual = 0;
        for (int iteration = 0; iteration < 60; ++iteration) {
            contact.fixFriction(x);
            contact.beginIteration(x);
            std::vector<Vec3> force{world.acceleration * mass};
            contact.addForces(x, force);
            residual = length(force[0]);
            fixtures::DenseSink hessian(1);
            contact.addHessian(x, hessian);
            // the plane is level: x and y do not mix. At most 1 mm per iteration.
            const double stiffnessX = std::max(hessian.values[0], 1e-9), stiffnessY = std::max(hessian.values[4], 1e-3);
            x[0].x += std::clamp(force[0].x / stiffnessX, -1e-3, 1e-3);
            x[0].y += std::clamp(force[0].y / stiffnessY, -1e-3, 1e-3);
        }
        if (angle < 16.6) {
            QVERIFY(residual < 1e-3 * weight);
            QVERIFY(distance(x[0], start) < 1.1e-4); // friction builds up within frictionGive
        } else {
            QVERIFY(x[0].x - start.x > 5e-3); // nothing holds it: it goes as far as the iterations let it
        }
    }
}

/// A sample is let go a little and moved aside.
void tst_BodyContactStatics::frictionGoesPartOfTheWayToTheForcesOfHere() {
    const auto body = surfaceOf(shapes::starBody(30, 40, [](const Vec3&) { return 0.1; }));
    const Vec3 up{0, 1, 0};
    const std::vector<Vec3> pressed{up * 0.1005}, less{up * 0.101}, aside{up * 0.101 + Vec3{1e-5, 0, 0}};
    const auto frictionAfter = [&](auto ease) {
        BodyContact contact(body, {sampleAt(0, 0.3)});
        contact.take({.span = 1}); // no statics: dents are not taken back
        contact.fixFriction(pressed);
        contact.fixFriction(pressed);
        contact.beginIteration(pressed);
        ease(contact);
        return contact.energy(aside) - contact.energy(less);
    };
    const auto going = [&](double part) {
        return frictionAfter([&](BodyContact& contact) {
            contact.fixFriction(less);
            contact.easeFriction(part);
        });
    };
    const double before = frictionAfter([](BodyContact&) {}), whole = going(1), change = before - whole;
    QVERIFY2(change > 0.1 * before, qPrintable(QString("%1 %2").arg(before).arg(whole)));
    QVERIFY(std::abs(whole - frictionAfter([&](BodyContact& contact) { contact.fixFriction(less); })) < 1e-9 * change);
    QVERIFY(std::abs(going(0) - before) < 1e-3 * change);
    QVERIFY(std::abs(going(0.25) - std::lerp(before, whole, 0.25)) < 1e-3 * change);
}

void tst_BodyContactStatics::aSheetDrapesOverABallAndStaysOutsideInStatics() {
    const int cells = 16;
    const double extent = 0.24;
    const auto patch = fixtures::gridPatch(fixtures::evenLines(extent, cells), fixtures::evenLines(extent, cells));
    cloth::ClothModel model;
    QVERIFY(cloth::appendPatch(model, patch, material::Fabric{}));
    const auto ball = surfaceOf(shapes::starBody(40, 60, [](const Vec3&) { return 0.1; }));
    dynamics::ParticleState state;
    for (const Vec2& m : patch.material) state.positions.push_back({m.x - extent / 2, 0.11, m.y - extent / 2});
    state.velocities.resize(state.positions.size());
    const std::vector<double> half(model.mass.size(), 0.0002), mu(model.mass.size(), 0.4);
    BodyContact contact(ball, dynamics::particleSamples(model, half, mu, 0.4));
    dynamics::Stage* stages[]{&contact};

    dynamics::Xpbd xpbd(model, {.damping = 2});
    for (int frame = 0; frame < 360; ++frame) {
        QVERIFY(xpbd.step(state, 1.0 / 60, 20, {0, -freeFall, 0}, stages));
        QVERIFY(contact.clearance(state.positions) > target - 1e-4);
    }
    double speed = 0;
    for (const Vec3& v : state.velocities) speed = std::max(speed, length(v));
    QVERIFY(speed < 0.02);
    const auto draped = contact.report(state.positions);
    QVERIFY(draped.contacts > 40);

    const auto report = dynamics::solveStatic(model, state, {0, -freeFall, 0}, stages);
    QVERIFY(report);
    QVERIFY(report->newton.converged);
    QVERIFY(report->displacementMaximum < 0.03); // it straightens what XPBD left stretched, and does not slide off
    const auto resting = contact.report(state.positions);
    QVERIFY(resting.smallestClearance > target - 3e-4); // dents stay below 0.3 mm
    QVERIFY(resting.contacts > 20);
}

void tst_BodyContactStatics::whatPressesHardRestsAtItsDistance_data() {
    QTest::addColumn<double>("weights"); // of itself that press on it
    QTest::addColumn<double>("least");   // and most it lies too near at the end [m]
    QTest::addColumn<double>("most");
    QTest::addRow("its weight") << 1.0 << -1e-6 << 1e-6;
    QTest::addRow("fifty times") << 50.0 << -1e-6 << 1e-6;
    QTest::addRow("three hundred times") << 300.0 << -5e-6 << 5e-6;
    QTest::addRow("a thousand times") << 1000.0 << 1.4e-4 << 1.45e-4; // 0.642 mm, of which 0.5 mm are taken back
    // 2.704 mm: a = k·(t/3 − onset/2 + t/6·(exp(6·dent/t − 2) − 1)) for a target t and k = 2.5e7 1/s². 12 mm, if the
    // push grew evenly
    QTest::addRow("thirty thousand times") << 30000.0 << 2.20e-3 << 2.21e-3;
}

void tst_BodyContactStatics::whatPressesHardRestsAtItsDistance() {
    QFETCH(const double, weights);
    QFETCH(const double, least);
    QFETCH(const double, most);
    const auto patch = fixtures::gridPatch(fixtures::evenLines(0.1, 8), fixtures::evenLines(0.1, 8));
    cloth::ClothModel model;
    QVERIFY(cloth::appendPatch(model, patch, material::Fabric{}));
    const auto floor = surfaceOf(shapes::plane(0.5, 2));
    dynamics::ParticleState state;
    for (const Vec2& m : patch.material) state.positions.push_back({m.x, target, m.y});
    state.velocities.resize(state.positions.size());
    const std::vector<double> half(model.mass.size(), 0.0002), mu(model.mass.size(), 0.4);
    BodyContact contact(floor, dynamics::particleSamples(model, half, mu, 0.4));
    dynamics::Stage* stages[]{&contact};
    const Vec3 load{0, -freeFall * weights, 0};
    dynamics::Xpbd xpbd(model, {});
    for (int again = 0; again < 3; ++again) {
        const auto report = dynamics::solveStatic(model, state, load, stages);
        QVERIFY(report);
        QVERIFY(report->newton.converged);
        QCOMPARE(report->newton.iterations == 0, again == 1); // it goes on from where it ended
        const double dent = target - contact.clearance(state.positions);
        QVERIFY2(dent > least && dent < most, qPrintable(QString::number(dent)));
        if (again == 1) QVERIFY(xpbd.step(state, 1e-3, 1, load, stages)); // what was taken back is forgotten
    }
}

namespace {

/// A sheet that is pressed on a floor, in balance by statics.
struct PressedSheet {
    cloth::ClothModel model;
    BodySurface floor = surfaceOf(shapes::plane(0.5, 2));
    dynamics::ParticleState state;
    std::vector<ContactSample> samples;
    Vec3 load{0, -20 * freeFall, 0};

    PressedSheet() {
        const auto patch = fixtures::gridPatch(fixtures::evenLines(0.1, 8), fixtures::evenLines(0.1, 8));
        if (!cloth::appendPatch(model, patch, material::Fabric{})) qFatal("no cloth");
        for (const Vec2& m : patch.material) state.positions.push_back({m.x, target, m.y});
        state.velocities.resize(state.positions.size());
        const std::vector<double> half(model.mass.size(), 0.0002), mu(model.mass.size(), 0.4);
        samples = dynamics::particleSamples(model, half, mu, 0.4);
    }
    /// How many iterations it took.
    int settle(BodyContact& contact) {
        dynamics::Stage* stages[]{&contact};
        const auto report = dynamics::solveStatic(model, state, load, stages);
        if (!report || !report->newton.converged) qFatal("no balance");
        return report->newton.iterations;
    }
};

} // namespace

/// Three thousand weights dent by 1.427 mm, a/k and half the onset, where statics would press back harder.
void tst_BodyContactStatics::explicitStepsAreAsStiffAsTheirLimitKnows() {
    for (const auto method : {dynamics::Method::symplecticEuler, dynamics::Method::rk4}) {
        PressedSheet sheet;
        BodyContact contact(sheet.floor, sheet.samples);
        dynamics::Stage* stages[]{&contact};
        const auto integrator = makeIntegrator(method, sheet.model, {.damping = 100});
        for (int frame = 0; frame < 20; ++frame)
            QVERIFY(integrator->step(sheet.state, 1.0 / 60, {0, -3000 * freeFall, 0}, stages));
        const double dent = target - contact.clearance(sheet.state.positions);
        QVERIFY2(std::abs(dent - 1.427e-3) < 2e-5, qPrintable(QString::number(dent)));
    }
}

void tst_BodyContactStatics::whatIsRecalledGoesOnAsItWas() {
    PressedSheet sheet;
    BodyContact contact(sheet.floor, sheet.samples), knows(sheet.floor, sheet.samples),
        knowsNothing(sheet.floor, sheet.samples);
    QVERIFY(sheet.settle(contact) > 0);
    const dynamics::ContactMemory memory = contact.memory();
    QVERIFY(std::ranges::max(memory.forces) > 0 && std::ranges::max(memory.takenBack) > 0);
    QVERIFY(knows.recall(memory));
    QVERIFY(knows.memory() == memory);
    const std::vector<Vec3> rested = sheet.state.positions;
    QCOMPARE(sheet.settle(knows), 0);
    QVERIFY(sheet.state.positions == rested);
    QVERIFY(sheet.settle(knowsNothing) > 0);

    std::vector<ContactSample> fewer = sheet.samples;
    fewer.pop_back();
    BodyContact other(sheet.floor, fewer);
    const dynamics::ContactMemory none = other.memory();
    QVERIFY(!other.recall(memory));
    QVERIFY(other.memory() == none);
}

void tst_BodyContactStatics::anotherContactGoesOnAsFarAsItsSamplesAreTheSame() {
    PressedSheet sheet;
    std::vector<ContactSample> more = sheet.samples;
    const auto middle = [&](int a, int b) {
        return dynamics::middleOf(std::array<const ContactSample*, 2>{&sheet.samples[a], &sheet.samples[b]});
    };
    more.push_back(middle(0, 1));
    more.push_back(middle(1, 2));
    BodyContact contact(sheet.floor, more);
    (void)sheet.settle(contact);
    const dynamics::ContactMemory before = contact.memory();
    const std::size_t same = sheet.samples.size() + 1;
    QVERIFY(before.forces.back() > 0);

    more.back() = middle(3, 4);
    more.push_back(middle(5, 6));
    BodyContact next(sheet.floor, more);
    next.goOnFrom(contact, sheet.state.positions);
    const dynamics::ContactMemory after = next.memory();
    QCOMPARE(after.forces.size(), more.size());
    for (std::size_t s = 0; s < more.size(); ++s) {
        QCOMPARE(after.forces[s], s < same ? before.forces[s] : 0);
        QCOMPARE(after.takenBack[s], s < same ? before.takenBack[s] : 0);
        if (s < same) QCOMPARE(after.anchors[s], before.anchors[s]);
    }
    const Vec3 between = 0.5 * (sheet.state.positions[5] + sheet.state.positions[6]);
    QVERIFY(geometry::distance(after.anchors.back(), between) < 1e-15);
}

/// Where the nearest wall changes, the distance to triangles has a kink that draws a particle into it from both sides.
void tst_BodyContactStatics::inAGrooveAParticleComesToRest() {
    const double slope = 0.35, mass = 2e-5, weight = mass * freeFall;
    auto mesh = shapes::plane(0.5, 2);
    for (Vec3& v : mesh.vertices) v.y = std::abs(v.x) * std::tan(slope);
    const auto groove = surfaceOf(std::move(mesh));
    for (const double start : {-0.0031, 0.0002, 0.0013}) {
        std::vector<Vec3> x{{start, std::abs(start) * std::tan(slope) + target / std::cos(slope), 0.02}};
        BodyContact contact(groove, {sampleAt(0, 0)});
        double residual = 0;
        for (int iteration = 0; iteration < 60; ++iteration) {
            contact.fixFriction(x);
            contact.beginIteration(x);
            std::vector<Vec3> force{{0, -weight, 0}};
            contact.addForces(x, force);
            residual = length(force[0]);
            DenseSink hessian(1);
            contact.addHessian(x, hessian);
            const double xx = hessian.values[0] + 1e-2, xy = hessian.values[1], yy = hessian.values[4] + 1e-2;
            const double of = xx * yy - xy * xy;
            const Vec3 step{(yy * force[0].x - xy * force[0].y) / of, (xx * force[0].y - xy * force[0].x) / of, 0};
            x[0] += step * std::min(1.0, 5e-4 / length(step));
        }
        QVERIFY(residual < 1e-3 * weight);
        QVERIFY(std::abs(x[0].x) < 1e-5);
    }
}

TOILE_TEST(tst_BodyContactStatics)
#include "tst_BodyContactStatics.moc"
