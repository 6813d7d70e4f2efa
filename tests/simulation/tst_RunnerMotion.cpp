// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunnerFixture.h"
#include "tests/Suite.h"

using namespace toile;
using namespace toile::simulation;

/// The body moves, or the method changes, while the simulation's thread runs. Run under the thread sanitizer, too.
class tst_RunnerMotion : public QObject {
    Q_OBJECT
private slots:
    void theBodyMovesAndClothThatRestedGoesAlong();
    void aMotionThatIsRefusedIsSaidAndMovesNothing();
    void aMotionForAGarmentThatCannotBeBuiltIsRefused();
    void anotherMethodTakesOver();
    void aMethodWaitsUntilTheBodyStandsStill();
};

void tst_RunnerMotion::theBodyMovesAndClothThatRestedGoesAlong() {
    Runner runner;
    Scene scene;
    scene.pattern.fabrics.push_back(plainCloth());
    pattern::Piece piece = polygonPiece("sheet", {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0, 0.3}}, 0.05);
    piece.placement = pattern::Placement{};
    piece.placement->transform = {.axisX = {1, 0, 0}, .axisY = {0, 0, -1}, .axisZ = {0, 1, 0}, .origin = {0, 0.51, 0}};
    scene.pattern.pieces.push_back(Shared<pattern::Piece>(std::move(piece)));
    scene.body = Shared<body::Body>(box());
    runner.setScene(scene, 1);
    runner.play();
    const auto rested = waitForFrame(runner, [](const Frame& frame) { return frame.atRest; });
    QVERIFY(rested && !rested->body);

    const std::vector<Vec3>& vertices = (*scene.body)->mesh.vertices;
    geometry::VertexMotion up{0.2, {vertices, vertices}};
    for (Vec3& v : up.poses[1]) v.y += 0.1;
    runner.moveBody(std::make_shared<const geometry::VertexMotion>(up));
    const auto lifted = waitForFrame(runner, [&](const Frame& frame) {
        return frame.atRest && frame.body && (*frame.body)->mesh.vertices == up.poses[1];
    });
    QVERIFY(lifted);
    for (std::size_t v = 0; v < lifted->positions.size(); ++v)
        QVERIFY(std::abs(lifted->positions[v].y - rested->positions[v].y - 0.1) < 2e-3);

    runner.moveBody(std::make_shared<const geometry::VertexMotion>(up)); // it does not begin where the body is
    const auto refused = waitForFrame(runner, [](const Frame& frame) { return !frame.message.empty(); });
    QVERIFY(refused && refused->message.find("off by 100.0 mm") != std::string::npos);
    runner.askForCheckpoint();
    std::optional<Result<Checkpoint>> checkpoint;
    QTRY_VERIFY(checkpoint || (checkpoint = runner.takeCheckpoint()));
    QVERIFY(!*checkpoint && checkpoint->error().text.find("avatar has moved") != std::string::npos);

    std::ranges::reverse(up.poses);
    runner.moveBody(std::make_shared<const geometry::VertexMotion>(up));
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.atRest && !frame.body; }));
}

void tst_RunnerMotion::aMotionThatIsRefusedIsSaidAndMovesNothing() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    scene.body = Shared<body::Body>(box());
    const std::vector<Vec3>& vertices = (*scene.body)->mesh.vertices;
    const auto wrong = std::make_shared<const geometry::VertexMotion>(
        geometry::VertexMotion{0.2, {std::vector<Vec3>(vertices.size(), Vec3{1, 1, 1}), vertices}});
    runner.setScene(scene, 1);
    runner.moveBody(wrong); // while it stands
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return !frame.message.empty(); }));
    QVERIFY(QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000));
    QVERIFY(!runner.isPlaying());

    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.time > 0.05; }));
    runner.moveBody(wrong); // while it plays: more frames come than are taken
    const auto seen = waitForFrame(runner, [](const Frame& frame) {
        QTest::qSleep(20);
        return !frame.message.empty();
    });
    QVERIFY(seen);
}

void tst_RunnerMotion::aMotionForAGarmentThatCannotBeBuiltIsRefused() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    scene.body = Shared<body::Body>(box());
    const std::vector<Vec3>& vertices = (*scene.body)->mesh.vertices;
    scene.pattern.seams[0].sides[0][0].edge = pattern::EdgeId("none");
    runner.setScene(scene, 1);
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return !frame.message.empty(); }));
    QVERIFY(QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000));
    runner.moveBody(std::make_shared<const geometry::VertexMotion>(geometry::VertexMotion{0.2, {vertices, vertices}}));
    const auto frame = waitForFrame(runner, [](const Frame& f) { return !f.message.empty(); });
    QVERIFY(frame && frame->message.find("no garment on a body") != std::string::npos);
    QVERIFY(!runner.isPlaying());
}

namespace {

/// Where two squares are that fell for so many frame steps, the second half of them by a method.
std::vector<Vec3> fallenBy(dynamics::Method method) {
    Runner runner;
    Scene scene = twoSquares(0.05);
    scene.pattern.seams.clear();
    scene.settings.gravity = {0, -9.81, 0};
    runner.setScene(scene, 1);
    std::vector<Vec3> positions;
    double time = 0;
    const auto step = [&] {
        runner.step();
        return QTest::qWaitFor(
            [&] {
                const auto frame = runner.takeFrame();
                if (!frame || frame->time <= time) return false;
                time = frame->time;
                positions = frame->positions;
                return true;
            },
            60000);
    };
    for (int i = 0; i < 10; ++i) {
        if (i == 5) runner.drapeWith(method);
        if (!step()) qFatal("no step");
    }
    return positions;
}

} // namespace

/// Two bodies in free fall, for which every method has an error of its own.
void tst_RunnerMotion::anotherMethodTakesOver() {
    const std::vector<Vec3> fast = fallenBy(dynamics::Method::xpbd), again = fallenBy(dynamics::Method::xpbd),
                            euler = fallenBy(dynamics::Method::backwardEuler);
    QVERIFY(fast == again);
    const double apart = geometry::distance(fast[0], euler[0]);
    QVERIFY2(apart > 1e-4 && apart < 0.02, qPrintable(QString::number(apart)));
}

void tst_RunnerMotion::aMethodWaitsUntilTheBodyStandsStill() {
    Runner runner;
    const Scene scene = sheetOnTable();
    runner.setScene(scene, 1);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.atRest; }));
    const std::vector<Vec3>& vertices = (*scene.body)->mesh.vertices;
    geometry::VertexMotion up{0.5, {vertices, vertices}};
    for (Vec3& v : up.poses[1]) v.y += 0.1;
    runner.moveBody(std::make_shared<const geometry::VertexMotion>(up));
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.bodyMoves; }));
    runner.drapeWith(dynamics::Method::trBdf2);
    const auto lifted = waitForFrame(runner, [&](const Frame& frame) {
        return frame.atRest && frame.body && (*frame.body)->mesh.vertices == up.poses[1];
    });
    QVERIFY(lifted);
    std::ranges::reverse(up.poses);
    runner.moveBody(std::make_shared<const geometry::VertexMotion>(up)); // it has taken over by then
    const auto refused = waitForFrame(runner, [](const Frame& frame) { return !frame.message.empty(); });
    QVERIFY(refused && refused->message.find("by xpbd alone") != std::string::npos);
}

TOILE_TEST(tst_RunnerMotion, QCoreApplication)
#include "tst_RunnerMotion.moc"
