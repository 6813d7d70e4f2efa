// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/dynamics/ContactWorld.h"

#include <QTest>

using namespace toile;
using namespace toile::contactWorld;
using collision::MovingSurface;
using geometry::VertexMotion;

namespace {

/// A plane that goes so far in a second, in one straight way.
std::shared_ptr<const VertexMotion> going(const geometry::TriangleMesh& mesh, const Vec3& way, double seconds) {
    VertexMotion motion{seconds, {mesh.vertices, mesh.vertices}};
    for (Vec3& v : motion.poses[1]) v += way * seconds;
    return std::make_shared<const VertexMotion>(std::move(motion));
}

/// Particles beside a body that moves, in substeps that know the time.
void run(World& world, BodyContact& contact, double seconds, double step) {
    contact.beginStep({world.positions, world.velocities, 0}, seconds);
    for (int s = 1; s <= std::lround(seconds / step); ++s) {
        const std::vector<Vec3> previous = world.positions;
        for (std::size_t i = 0; i < world.positions.size(); ++i)
            world.positions[i] += (world.velocities[i] + world.acceleration * step) * step;
        dynamics::Substep view{world.positions, previous, world.inverseMass, step, s * step};
        contact.project(view);
        for (std::size_t i = 0; i < world.positions.size(); ++i)
            world.velocities[i] = (world.positions[i] - previous[i]) / step;
    }
}

} // namespace

class tst_MovingBody : public QObject {
    Q_OBJECT
private slots:
    void clothIsLiftedAsFastAsTheBodyRises();
    void frictionCarriesClothAlong_data();
    void frictionCarriesClothAlong();
    void fastBodiesDoNotLeapThroughCloth_data();
    void fastBodiesDoNotLeapThroughCloth();
    void aBodyThatStandsStillInItsMotionIsOneThatDoesNotMove();
};

void tst_MovingBody::clothIsLiftedAsFastAsTheBodyRises() {
    const geometry::TriangleMesh mesh = shapes::plane(2, 8);
    MovingSurface moving(mesh, going(mesh, {0, 1, 0}, 0.5), 0);
    BodyContact contact(moving.surface(), {sampleAt(0, 0.3)});
    contact.follow(moving);
    World world({{0.1, target, 0.2}});
    world.velocities[0] = {0, 1, 0};
    run(world, contact, 0.5, h);
    QVERIFY(geometry::distance(world.positions[0], {0.1, 0.5 + target, 0.2}) < 1e-9);
    QVERIFY(geometry::distance(world.velocities[0], {0, 1, 0}) < 1e-6);
}

void tst_MovingBody::frictionCarriesClothAlong_data() {
    QTest::addColumn<double>("friction");
    QTest::newRow("none") << 0.0;
    QTest::newRow("slips all the way") << 0.3;
    QTest::newRow("sticks in the end") << 0.8;
}

/// On a belt of 2 m/s cloth speeds up by μg until it goes along: after t it is at ½μgt², or v·t − v²/2μg.
void tst_MovingBody::frictionCarriesClothAlong() {
    QFETCH(double, friction);
    constexpr double seconds = 0.5, belt = 2;
    const geometry::TriangleMesh mesh = shapes::plane(3, 8);
    MovingSurface moving(mesh, going(mesh, {belt, 0, 0}, seconds), 0);
    BodyContact contact(moving.surface(), {sampleAt(0, friction)});
    contact.follow(moving);
    World world({{0, target, 0.2}});
    run(world, contact, seconds, h);
    const double pull = friction * freeFall;
    const bool sticks = pull * seconds > belt;
    const double way = sticks ? belt * seconds - belt * belt / (2 * pull) : pull * seconds * seconds / 2;
    QVERIFY2(std::abs(world.positions[0].x - way) < 0.005 * belt * seconds,
             qPrintable(QString("%1 instead of %2").arg(world.positions[0].x).arg(way)));
    QVERIFY(std::abs(world.positions[0].y - target) < 1e-6);
    QVERIFY(std::abs(world.velocities[0].x - (sticks ? belt : pull * seconds)) < 0.01);
}

void tst_MovingBody::fastBodiesDoNotLeapThroughCloth_data() {
    QTest::addColumn<double>("speed");
    for (const double speed : {0.5, 3.0, 20.0}) QTest::addRow("%.1f m/s", speed) << speed;
}

/// A board of 4 mm, thinner than twice the distance kept, strikes cloth that hangs still: the cloth goes before it.
void tst_MovingBody::fastBodiesDoNotLeapThroughCloth() {
    QFETCH(double, speed);
    const geometry::TriangleMesh board = shapes::box({-0.014, -0.5, -0.5}, {-0.010, 0.5, 0.5});
    const double seconds = 1 / speed, step = std::min(h, 0.0015 / speed);
    MovingSurface moving(board, going(board, {speed, 0, 0}, seconds), 0);
    std::vector<Vec3> at;
    std::vector<ContactSample> samples;
    for (int i = 0; i < 9; ++i) {
        at.push_back({0, 0.1 * (i - 4), 0.03 * i});
        samples.push_back(sampleAt(i, 0.2));
    }
    BodyContact contact(moving.surface(), std::move(samples));
    contact.follow(moving);
    World world(at);
    world.acceleration = {};
    run(world, contact, std::floor(seconds / step) * step, step);
    for (const Vec3& p : world.positions) QVERIFY2(p.x > speed * seconds * 0.9, qPrintable(QString::number(p.x)));
    QVERIFY(contact.clearance(world.positions) > target - 1e-4);
}

void tst_MovingBody::aBodyThatStandsStillInItsMotionIsOneThatDoesNotMove() {
    const geometry::TriangleMesh mesh = shapes::bumpySphere();
    const BodySurface standing = surfaceOf(mesh);
    MovingSurface moving(mesh, going(mesh, {}, 1), 0);
    std::vector<Vec3> at;
    std::vector<ContactSample> samples;
    std::mt19937 random(4);
    for (int i = 0; i < 50; ++i) {
        const Vec3 d = normalized(shapes::randomPoint(random, 1) + Vec3{0, 1.2, 0});
        at.push_back(d * 1.15);
        samples.push_back(sampleAt(i, 0.4));
    }
    BodyContact still(standing, samples), follows(moving.surface(), samples);
    follows.follow(moving);
    World a(at), b(at);
    run(a, still, 0.5, h);
    run(b, follows, 0.5, h);
    for (int i = 0; i < 50; ++i) // the one trusts its tangent planes over a quarter of a millimetre
        QVERIFY2(geometry::distance(a.positions[i], b.positions[i]) < 0.01,
                 qPrintable(QString::number(geometry::distance(a.positions[i], b.positions[i]))));
    QVERIFY(follows.clearance(b.positions) > target - 1e-4);
}

TOILE_TEST(tst_MovingBody)
#include "tst_MovingBody.moc"
