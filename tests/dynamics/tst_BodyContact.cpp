// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/dynamics/ContactWorld.h"

#include <QTest>

using namespace toile;
using namespace toile::contactWorld;
using dynamics::BodyContactSettings;

namespace {

/// A square of particles 10 mm apart, joined to their neighbours by stiff position constraints.
struct ParticleSquare {
    int side;
    World world;
    std::vector<ContactSample> samples;

    ParticleSquare(int n, double height, double friction) : side(n), world(grid(n, height)) {
        for (int i = 0; i < n * n; ++i) samples.push_back(sampleAt(i, friction));
        world.cloth = [n](std::span<Vec3> x, double) {
            const auto join = [&](int a, int b) {
                const Vec3 d = x[b] - x[a];
                const Vec3 half = d * (0.5 * (length(d) - 0.01) / length(d));
                x[a] += half;
                x[b] += -half;
            };
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    if (i + 1 < n) join(i * n + j, (i + 1) * n + j);
                    if (j + 1 < n) join(i * n + j, i * n + j + 1);
                }
        };
    }
    static std::vector<Vec3> grid(int n, double height) {
        std::vector<Vec3> at;
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) at.push_back({0.01 * i, height, 0.01 * j});
        return at;
    }
    [[nodiscard]] Vec3 middle() const {
        Vec3 sum;
        for (const Vec3& x : world.positions) sum += x;
        return sum / double(world.positions.size());
    }
};

} // namespace

class tst_BodyContact : public QObject {
    Q_OBJECT
private slots:
    void aBlockSticksExactlyUpToItsAngleOfFriction();
    void aBlockSlidesWithTheAccelerationOfCoulomb();
    void aPatchOfClothSlidesAndSticksAsOneBlock();
    void nothingFallsThroughAPlane_data();
    void nothingFallsThroughAPlane();
    void aParticleAtItsDistanceStaysThere();
    void nothingTunnelsThroughALimb_data();
    void nothingTunnelsThroughALimb();
    void anOverlapIsLedOutWithBoundedSpeed();
    void whatLayersPressInDoesNotCreep();
    void slidingOverABodyKeepsItsDistance();
    void aSampleBetweenParticlesIsHeldOut();
    void aPinnedParticleIsNotMoved();
    void whatIsKnownToBePinnedIsNotLookedAt();
    void aSampleOfASlaveMovesItsMasters();
    void theReportNamesTheDeepestPoint();
};

void tst_BodyContact::aBlockSticksExactlyUpToItsAngleOfFriction() {
    const auto plane = surfaceOf(shapes::plane(1, 8));
    const double mu = 0.3, critical = std::atan(mu); // 16.699 degrees
    for (const double angle : {0.0, 5 * degrees, critical - 0.2 * degrees}) {
        World world({{0, target, 0}});
        world.acceleration = slope(angle);
        BodyContact contact(plane, {sampleAt(0, mu)});
        world.run(contact, 1);
        QVERIFY(distance(world.positions[0], {0, target, 0}) < 1e-12); // creep of one second: rounding only
    }
    World world({{0, target, 0}});
    world.acceleration = slope(critical + 0.2 * degrees);
    BodyContact contact(plane, {sampleAt(0, mu)});
    world.run(contact, 0.5);
    QVERIFY(world.positions[0].x > 1e-3);
}

void tst_BodyContact::aBlockSlidesWithTheAccelerationOfCoulomb() {
    const auto plane = surfaceOf(shapes::plane(4, 16));
    const double mu = 0.3, angle = 30 * degrees;
    World world({{0, target, 0}});
    world.acceleration = slope(angle);
    BodyContact contact(plane, {sampleAt(0, mu)});
    world.run(contact, 1);
    const double expected = freeFall * (std::sin(angle) - mu * std::cos(angle)); // 2.3563 m/s²
    QVERIFY(std::abs(world.velocities[0].x - expected) < 1e-9 * expected); // constant forces: exact but for rounding
}

void tst_BodyContact::aPatchOfClothSlidesAndSticksAsOneBlock() {
    const auto plane = surfaceOf(shapes::plane(4, 16));
    const double mu = 0.3;
    ParticleSquare stuck(5, target, mu);
    stuck.world.acceleration = slope(16.5 * degrees);
    BodyContact holding(plane, stuck.samples);
    const Vec3 start = stuck.middle();
    stuck.world.run(holding, 1);
    QVERIFY(distance(stuck.middle(), start) < 1e-9);

    ParticleSquare sliding(5, target, mu);
    sliding.world.acceleration = slope(30 * degrees);
    BodyContact passing(plane, sliding.samples);
    sliding.world.run(passing, 1);
    const double expected = freeFall * (std::sin(30 * degrees) - mu * std::cos(30 * degrees));
    double speed = 0;
    for (const Vec3& v : sliding.world.velocities) speed += v.x / 25;
    QVERIFY(std::abs(speed - expected) < 0.01 * expected); // V9: 1 %
}

void tst_BodyContact::nothingFallsThroughAPlane_data() {
    QTest::addColumn<double>("speed");
    for (const double speed : {1.0, 3.0, 10.0, 30.0, 100.0})
        QTest::newRow(qPrintable(QString("%1 m/s").arg(speed))) << speed;
}

void tst_BodyContact::nothingFallsThroughAPlane() {
    QFETCH(double, speed);
    const auto plane = surfaceOf(shapes::plane(4, 16));
    for (const double step : {1.0 / 60, 1.0 / 1200}) {
        World world({{0.011, 0.5, 0.007}});
        world.velocities[0] = {0.1 * speed, -speed, 0};
        BodyContact contact(plane, {sampleAt(0, 0.3)});
        double energy = 0.5 * squaredLength(world.velocities[0]) + freeFall * 0.5;
        const double initial = energy;
        for (int n = 0; n * step < 1; ++n) {
            world.substep(contact, step);
            QVERIFY(world.positions[0].y > target - 2e-5); // the sweep stops within 10 µm; V26
            energy = 0.5 * squaredLength(world.velocities[0]) + freeFall * world.positions[0].y;
            QVERIFY(energy <= initial + 1e-9);
        }
        QVERIFY(std::abs(world.positions[0].y - target) < 1e-6); // it came to lie where it should
        QVERIFY(std::abs(world.velocities[0].y) < 1e-6);
    }
}

void tst_BodyContact::aParticleAtItsDistanceStaysThere() {
    const auto body = surfaceOf(shapes::box({-1, -1, -1}, {1, 0, 1}));
    World world({{0.123, target, 0.456}});
    BodyContact contact(body, {sampleAt(0, 0.3)});
    world.run(contact, 5);
    QVERIFY(distance(world.positions[0], {0.123, target, 0.456}) < 1e-12);
}

void tst_BodyContact::nothingTunnelsThroughALimb_data() {
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("step");
    for (const double speed : {1.0, 5.0, 20.0})
        for (const double step : {1.0 / 2400, 1.0 / 600, 1.0 / 60})
            QTest::newRow(qPrintable(QString("%1 m/s in steps of %2 s").arg(speed).arg(step))) << speed << step;
}

void tst_BodyContact::nothingTunnelsThroughALimb() {
    QFETCH(double, speed);
    QFETCH(double, step);
    const auto limb = surfaceOf(shapes::starBody(16, 24, [](const Vec3&) { return 0.02; })); // 40 mm thick
    std::mt19937 random(21);
    for (int n = 0; n < 40; ++n) {
        const Vec3 from = normalized(shapes::randomPoint(random, 1)) * 0.1;
        const Vec3 aim = shapes::randomPoint(random, 0.008);
        World world({from});
        world.acceleration = {};
        world.velocities[0] = normalized(aim - from) * speed;
        BodyContact contact(limb, {sampleAt(0, 0.3)});
        for (int k = 0; k * step * speed < 0.3; ++k) {
            world.substep(contact, step);
            QVERIFY(contact.clearance(world.positions) > 0);
        }
    }
}

void tst_BodyContact::anOverlapIsLedOutWithBoundedSpeed() {
    const auto body = surfaceOf(shapes::box({-1, -1, -1}, {1, 0, 1}));
    World world({{0, -0.05, 0}}); // 50 mm inside
    BodyContact contact(body, {sampleAt(0, 0.3)});
    const BodyContactSettings settings;
    double highest = -1;
    for (int n = 0; n < 1200; ++n) {
        world.substep(contact, h);
        QVERIFY(length(world.velocities[0]) <= settings.pushOutSpeed + 1e-9);
        highest = std::max(highest, world.positions[0].y);
    }
    QVERIFY(std::abs(world.positions[0].y - target) < 1e-6);
    QVERIFY(highest < target + 5e-4); // it leaves the overlap without a jump: (1 mm / 20 ms)² / 2g = 0.13 mm
}

/// A stage after contact takes the particle 20 µm towards the body in every substep, as layers do that are pulled on to
/// it: led out as an overlap of d by (1 − e^(−h/τ))d in a substep, it would end where that is 20 µm, at d = 0.49 mm.
void tst_BodyContact::whatLayersPressInDoesNotCreep() {
    const auto plane = surfaceOf(shapes::plane(1, 8));
    const double pressed = 2e-5;
    const BodyContactSettings settings;
    const double creep = pressed / (1 - std::exp(-h / settings.pushOutTime));
    for (const bool bears : {false, true}) {
        BodyContact contact(plane, {sampleAt(0, 0)}, {.bearsLayers = bears});
        World world({{0, target, 0}});
        contact.beginStep({world.positions, world.velocities, 0}, 1);
        double reached = 0;
        for (int substep = 0; substep < 2000; ++substep) {
            const Vec3 before = world.positions[0];
            world.substep(contact, h);
            reached = world.positions[0].y;
            world.positions[0].y -= pressed;
            world.velocities[0] = (world.positions[0] - before) / h;
        }
        const double missing = target - reached;
        if (bears) QVERIFY2(std::abs(missing) < 1e-12, qPrintable(QString::number(missing)));
        else QVERIFY2(std::abs(missing + pressed - creep) < 0.02 * creep, qPrintable(QString::number(missing)));
    }
}

void tst_BodyContact::slidingOverABodyKeepsItsDistance() {
    const auto body = surfaceOf(shapes::starBody(60, 90, [](const Vec3&) { return 0.1; }));
    std::mt19937 random(22);
    for (int n = 0; n < 20; ++n) {
        const Vec3 up = normalized(shapes::randomPoint(random, 1));
        const Vec3 along = normalized(cross(up, Vec3{0.3, 0.5, -0.7}));
        World world({up * (0.1 + target)});
        world.velocities[0] = along;
        BodyContact contact(body, {sampleAt(0, 0.1)});
        for (int k = 0; k < 1200; ++k) {
            world.acceleration = normalized(world.positions[0]) * -30.0; // pressed on, faster than it flies off
            world.substep(contact, h);
            const double off = contact.clearance(world.positions) - target;
            QVERIFY(off > -1e-4 && off < 1e-4); // facets of 7 mm on a radius of 100 mm: 0.06 mm deep
        }
    }
}

void tst_BodyContact::aSampleBetweenParticlesIsHeldOut() {
    const auto limb = surfaceOf(shapes::starBody(40, 60, [](const Vec3&) { return 0.04; }));
    // a stiff 40 mm cell across the limb: its corners are far off while its middle would sink in
    World world({{-0.02, 0.05, -0.02}, {0.02, 0.05, -0.02}, {0.02, 0.05, 0.02}, {-0.02, 0.05, 0.02}});
    std::vector<ContactSample> samples;
    for (int i = 0; i < 4; ++i) samples.push_back(sampleAt(i, 0.3));
    const ContactSample middle =
        dynamics::middleOf(std::array<const ContactSample*, 4>{&samples[0], &samples[1], &samples[2], &samples[3]});
    QCOMPARE(middle.mass, 2e-5);
    samples.push_back(middle);
    BodyContact contact(limb, samples);
    world.cloth = [](std::span<Vec3> x, double) { // keeps it flat and level
        double height = 0;
        for (const Vec3& p : x) height += p.y / 4;
        for (Vec3& p : x) p.y = height;
    };
    world.run(contact, 0.5);
    const Vec3 centre = (world.positions[0] + world.positions[1] + world.positions[2] + world.positions[3]) / 4;
    QVERIFY(std::abs(limb.nearest(centre, 1)->signedDistance - target) < 2e-5); // one substep's fall: g h² = 7 µm
}

void tst_BodyContact::aPinnedParticleIsNotMoved() {
    const auto body = surfaceOf(shapes::box({-1, -1, -1}, {1, 0, 1}));
    World world({{0, -0.01, 0}});
    world.inverseMass[0] = 0;
    BodyContact contact(body, {sampleAt(0, 0.3)});
    world.run(contact, 0.1);
    QCOMPARE(world.positions[0], (Vec3{0, -0.01, 0}));
    QCOMPARE(contact.report(world.positions).largestPenetration, 0.01); // and the depth is told
}

/// Where it is looked at, far from the body, what pressed it begins to be forgotten.
void tst_BodyContact::whatIsKnownToBePinnedIsNotLookedAt() {
    const auto body = surfaceOf(shapes::box({-1, -1, -1}, {1, 0, 1}));
    const ContactSample between{{{0, 0.5}, {1, 0.5}}, 0.0002, 0.3, 2e-5}, half{{{0, 0.5}, {2, 0.5}}, 0.0002, 0.3, 2e-5};
    const std::vector<ContactSample> samples{sampleAt(0, 0.3), sampleAt(1, 0.3), sampleAt(2, 0.3), between, half};
    using Kept = std::vector<bool>;
    for (const auto& [pinned, kept] : {std::pair{std::vector<int>{}, Kept{false, false, false, false, false}},
                                       std::pair{std::vector{0, 1}, Kept{true, true, false, true, false}}}) {
        BodyContact contact(body, samples, {}, pinned);
        QVERIFY(contact.recall({.forces = {1, 1, 1, 1, 1}, .takenBack = {0, 0, 0, 0, 0}}));
        World world({{0, 0.5, 0}, {0.1, 0.5, 0}, {0.2, 0.5, 0}});
        world.substep(contact, h);
        for (std::size_t s = 0; s < kept.size(); ++s) QCOMPARE(contact.memory().forces[s] == 1, bool(kept[s]));
    }
}

void tst_BodyContact::aSampleOfASlaveMovesItsMasters() {
    cloth::ClothModel model;
    model.mass = {1e-5, 1e-5, 0};
    model.slaves = {{2, {{0, 0.25}, {1, 0.75}}}};
    const std::vector<double> half{0.0002, 0.0002, 0.0002}, mu{0.4, 0.4, 0.4};
    const auto samples = dynamics::particleSamples(model, half, mu, 0.1);
    QCOMPARE(samples.size(), std::size_t(3));
    QCOMPARE(samples[0].friction, 0.2); // √(0.4 · 0.1)
    QVERIFY(samples[2].particles == model.slaves[0].masters);

    const auto body = surfaceOf(shapes::box({-1, -1, -1}, {1, 0, 1}));
    BodyContact contact(body, {samples[2]});
    const double low = target - 1e-5;
    std::vector<Vec3> previous(3, {0, target, 0}), positions(3, {0, low, 0});
    const std::vector<double> inverseMass{1e5, 1e5, (0.25 * 0.25 + 0.75 * 0.75) * 1e5};
    dynamics::Substep substep{positions, previous, inverseMass, h, 0};
    contact.project(substep);
    QVERIFY(std::abs(0.25 * positions[0].y + 0.75 * positions[1].y - target) < 1e-15);
    QVERIFY(std::abs((positions[1].y - low) / (positions[0].y - low) - 3) < 1e-9); // by weight
    QCOMPARE(positions[2].y, low);
}

void tst_BodyContact::theReportNamesTheDeepestPoint() {
    const auto body = surfaceOf(shapes::box({-1, -1, -1}, {1, 0, 1}));
    BodyContact contact(body, {sampleAt(0, 0.3), sampleAt(1, 0.3), sampleAt(2, 0.3)});
    const std::vector<Vec3> apart{{0, 0.02, 0}, {0.1, target, 0}, {0.2, 0.7, 0}};
    QCOMPARE(contact.report(apart).contacts, 1);
    QVERIFY(std::abs(contact.clearance(apart) - target) < 1e-15);
    QCOMPARE(contact.report(apart).largestPenetration, 0.0);
    const std::vector<Vec3> inside{{0, 0.02, 0}, {0.1, -0.004, 0}, {0.2, -0.1, 0}};
    QVERIFY(std::abs(contact.report(inside).largestPenetration - 0.1) < 1e-15);
}

TOILE_TEST(tst_BodyContact)
#include "tst_BodyContact.moc"
