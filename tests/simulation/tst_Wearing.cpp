// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Wearing.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"
#include "tests/simulation/SmallScenes.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;
using geometry::VertexMotion;

namespace {

/// The table is pushed to the right and back and lifted, in so many seconds.
std::shared_ptr<const VertexMotion> pushed(const Scene& scene, const Vec3& way, double seconds) {
    const std::vector<Vec3>& vertices = (*scene.body)->mesh.vertices;
    VertexMotion motion{seconds / 2, {vertices, vertices, vertices}};
    for (Vec3& v : motion.poses[1]) v += way / 2;
    for (Vec3& v : motion.poses[2]) v += way;
    return std::make_shared<const VertexMotion>(std::move(motion));
}

Vec3 middleOf(const Simulation& simulation) {
    Vec3 sum;
    for (const Vec3& p : simulation.state().positions) sum += p;
    return sum / static_cast<double>(simulation.state().positions.size());
}

} // namespace

class tst_Wearing : public QObject {
    Q_OBJECT
private slots:
    void clothGoesAlongWithItsBody();
    void aFastBodyTakesMoreSubsteps();
    void clothOnTheSkinItselfGoesAlongAsWell();
    void motionsThatCannotBeAreRefused();
    void nothingSettlesWhileTheBodyMoves();
    void cancelledMotionsStop();
};

void tst_Wearing::clothGoesAlongWithItsBody() {
    const Scene scene = sheetOnTable();
    Simulation simulation = simulationOf(scene);
    QVERIFY(sewn(simulation).atRest);
    const Vec3 before = middleOf(simulation), way{0.1, 0.2, -0.05};
    int frames = 0;
    const auto report = wear(simulation, pushed(scene, way, 1), {}, {}, {}, [&](const Simulation&) { ++frames; });
    QVERIFY2(report.has_value(), report ? "" : toString(report.error()).c_str());
    QVERIFY(!simulation.bodyMoves());
    QCOMPARE(report->steps, 60);
    QVERIFY(frames > 60); // and comes to rest
    QVERIFY(std::abs(report->seconds - 1) < 1e-9);
    QVERIFY(std::abs(report->bodySpeed - length(way)) < 1e-6);
    QVERIFY(report->reachedItsGoal());
    QCOMPARE(report->contact.bodyIntersections, 0);
    QVERIFY(std::abs(report->hemRise - way.y) < 1e-3);
    // it starts and stops with a jerk, in which cloth slips a little
    QVERIFY(geometry::distance(middleOf(simulation), before + way) < 0.02);
    QVERIFY(simulation.body()->mesh().vertices == pushed(scene, way, 1)->poses.back());
    QVERIFY(toText(toJson(*report)).find("bodySpeedMaximum") != std::string::npos);
}

void tst_Wearing::aFastBodyTakesMoreSubsteps() {
    const Scene scene = sheetOnTable();
    Simulation simulation = simulationOf(scene);
    const int substeps = simulation.substeps();
    QVERIFY(simulation.moveBody(pushed(scene, {0, 3, 0}, 0.5)).has_value());
    QVERIFY(simulation.advance().has_value());
    // 0.1 m in a frame step: 10 plans of 10 mm, 13⅓ quarters of the skin offset each
    QVERIFY(substeps < 140);
    QCOMPARE(simulation.phases().back().steps.parts, 10 * 14);
}

void tst_Wearing::clothOnTheSkinItselfGoesAlongAsWell() {
    Scene scene = sheetOnTable();
    scene.settings.skinOffset = 0;
    Simulation simulation = simulationOf(scene);
    const Vec3 before = middleOf(simulation), way{0, 0.1, 0};
    QVERIFY(simulation.moveBody(pushed(scene, way, 0.5)).has_value());
    while (simulation.bodyMoves()) QVERIFY(simulation.advance().has_value());
    QVERIFY(middleOf(simulation).y > 0.6); // the table is that high now
    QVERIFY(simulation.phases().back().steps.parts < 30 * 100);
    QVERIFY(before.y < 0.6);
}

void tst_Wearing::motionsThatCannotBeAreRefused() {
    const Scene scene = sheetOnTable();
    const auto refusal = [&](Simulation& simulation, const std::shared_ptr<const VertexMotion>& motion) {
        const auto moved = simulation.moveBody(motion);
        return moved ? std::string() : moved.error().text;
    };
    const auto motion = pushed(scene, {0, 0.1, 0}, 1);
    Scene bare = scene;
    bare.body.reset();
    Simulation without = simulationOf(bare);
    QVERIFY(refusal(without, motion).find("no body") != std::string::npos);

    Simulation other = simulationOf(scene);
    other.drapeWith(dynamics::Method::trBdf2);
    QVERIFY(refusal(other, motion).find("by xpbd alone") != std::string::npos);

    VertexMotion shorter = *motion;
    shorter.poses[1].pop_back();
    Simulation sound = simulationOf(scene);
    QVERIFY(refusal(sound, std::make_shared<const VertexMotion>(shorter)).find("Pose 2") != std::string::npos);

    Scene open = twoSquares();
    open.body = Shared<body::Body>(box());
    Simulation sewing = simulationOf(open);
    QVERIFY(refusal(sewing, motion).find("still being put on") != std::string::npos);
}

void tst_Wearing::nothingSettlesWhileTheBodyMoves() {
    const Scene scene = sheetOnTable();
    Simulation simulation = simulationOf(scene);
    QVERIFY(simulation.moveBody(pushed(scene, {0, 0.1, 0}, 1)).has_value());
    const auto before = simulation.state().positions;
    QVERIFY(!simulation.settle({}));
    QVERIFY(simulation.state().positions == before);
}

void tst_Wearing::cancelledMotionsStop() {
    const Scene scene = sheetOnTable();
    Simulation simulation = simulationOf(scene);
    std::stop_source stop;
    stop.request_stop();
    const auto report = wear(simulation, pushed(scene, {0, 0.1, 0}, 1), {}, stop.get_token());
    QVERIFY(!report);
    QVERIFY(report.error().code == ErrorCode::cancelled);
}

TOILE_TEST(tst_Wearing)
#include "tst_Wearing.moc"
