// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/Runner.h"
#include "core/simulation/SceneCheck.h"

#include <QTest>
#include <limits>
#include <random>

using namespace toile;
using namespace toile::simulation;

Q_DECLARE_METATYPE(std::function<void(toile::simulation::Runner&)>)

/// The simulation's thread. Run under the thread sanitizer, too.
class tst_Runner : public QObject {
    Q_OBJECT
private slots:
    void aSceneGivesAFrameAtOnce();
    void playingGoesOnAndPauseStops();
    void aSceneHandedOverBeforePlayIsTheOneThatPlays();
    void aStepIsOneFrame();
    void resetReturnsToThePlacement();
    void aFrameStepIsNotWaitedFor_data();
    void aFrameStepIsNotWaitedFor();
    void aWrongSceneGivesAMessage();
    void settingsThatNoSimulationCanRunWithGiveAMessage();
    void aGarmentGoesOnAfterASceneThatCannotBeBuilt();
    void aGarmentAtRestSleepsUntilSomethingChanges();
    void aHandWakesAGarmentAtRest();
    void aGarmentAtRestIsFinishedByStatics();
    void whatIsWrongWithItIsSaidThen();
    void theWayToTheEquilibriumHasNoJumps();
    void everyOrderStopsStatics_data();
    void everyOrderStopsStatics();
    void aCheckpointIsGoneOnFromByAnotherRunner();
    void aCheckpointOfAnotherSceneIsRefused();
    void theBodyMovesAndClothThatRestedGoesAlong();
    void aMotionThatIsRefusedIsSaidAndMovesNothing();
    void anotherMethodTakesOver();
    void aMethodWaitsUntilTheBodyStandsStill();
    void handsHoldAcrossACheckpoint();
    void aHandThatLetsGoOfABrokenSceneHoldsNoMore();
    void fiveHundredEditsWhileItSews();

private:
    static std::optional<Frame> waitForFrame(Runner& runner, std::function<bool(const Frame&)> wanted) {
        std::optional<Frame> found;
        (void)QTest::qWaitFor(
            [&] {
                if (auto frame = runner.takeFrame(); frame && wanted(*frame)) found = std::move(frame);
                return found.has_value();
            },
            60000);
        return found;
    }
};

void tst_Runner::aSceneGivesAFrameAtOnce() {
    Runner runner;
    QVERIFY(!runner.takeFrame());
    runner.setScene(twoSquares(0.05), 7);
    const auto frame = waitForFrame(runner, [](const Frame&) { return true; });
    QVERIFY(frame);
    QCOMPARE(frame->generation, std::uint64_t(7));
    QCOMPARE(frame->time, 0.0);
    QCOMPARE(frame->positions.size(), frame->topology->material.size());
    QVERIFY(frame->largestSeamGap > 0.19);
}

void tst_Runner::playingGoesOnAndPauseStops() {
    Runner runner;
    runner.setScene(twoSquares(0.05), 1);
    runner.play();
    QVERIFY(runner.isPlaying());
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.time > 0.05; }));
    runner.pause();
    QVERIFY(!runner.isPlaying());
}

void tst_Runner::aSceneHandedOverBeforePlayIsTheOneThatPlays() {
    const Scene first = twoSquares(0.005); // some milliseconds to build: the rest is ordered meanwhile
    Scene second = first;
    for (Shared<pattern::Piece>& shared : second.pattern.pieces) {
        pattern::Piece piece = *shared;
        piece.placement->transform.origin += Vec3{5, 0, 0};
        shared = Shared<pattern::Piece>(std::move(piece));
    }
    for (int i = 0; i < 10; ++i) {
        Runner runner;
        runner.setScene(first, 1);
        QTest::qSleep(i);
        runner.setScene(second, 2);
        runner.play();
        const auto frame = waitForFrame(runner, [](const Frame& f) { return f.generation == 2 && f.time > 0; });
        QVERIFY(frame);
        QVERIFY(frame->positions.front().x > 4); // where it was placed, not where the first one was played
    }
}

void tst_Runner::aStepIsOneFrame() {
    Runner runner;
    runner.setScene(twoSquares(0.05), 1);
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.time == 0; }));
    runner.step();
    const auto frame = waitForFrame(runner, [](const Frame& f) { return f.time > 0; });
    QVERIFY(frame);
    QCOMPARE(frame->time, 1.0 / 60);
}

void tst_Runner::resetReturnsToThePlacement() {
    Runner runner;
    runner.setScene(twoSquares(0.05), 1);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.time > 0.05; }));
    runner.reset();
    const auto frame = waitForFrame(runner, [](const Frame& f) { return f.time == 0; });
    QVERIFY(frame);
    QVERIFY(!runner.isPlaying());
}

void tst_Runner::aFrameStepIsNotWaitedFor_data() {
    QTest::addColumn<std::function<void(Runner&)>>("order");
    QTest::newRow("pause") << std::function<void(Runner&)>([](Runner& runner) { runner.pause(); });
    QTest::newRow("reset") << std::function<void(Runner&)>([](Runner& runner) { runner.reset(); });
    QTest::newRow("a checkpoint") << std::function<void(Runner&)>([](Runner& runner) { runner.resume({}); });
}

/// The step takes seconds; what it has done until then is dropped.
void tst_Runner::aFrameStepIsNotWaitedFor() {
    QFETCH(std::function<void(Runner&)>, order);
    Scene scene = twoSquares(0.005);
    scene.pattern.seams.clear(); // sewing takes few substeps
    scene.settings.substeps = mostSubsteps;
    Runner runner;
    runner.setScene(scene, 1);
    const auto placed = waitForFrame(runner, [](const Frame& frame) { return !frame.positions.empty(); });
    QVERIFY(placed);
    runner.play();
    QTest::qSleep(100);
    QVERIFY(!runner.takeFrame()); // it is under way
    order(runner);
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isBusy(), 60000);
    const auto stopped = runner.takeFrame();
    QVERIFY(stopped);
    QCOMPARE(stopped->time, 0.0);
    QVERIFY(stopped->positions == placed->positions);
    QVERIFY(!runner.isPlaying());
}

void tst_Runner::aWrongSceneGivesAMessage() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    scene.pattern.seams[0].sides[0][0].edge = pattern::EdgeId("none");
    runner.setScene(scene, 1);
    const auto frame = waitForFrame(runner, [](const Frame& f) { return !f.message.empty(); });
    QVERIFY(frame);
    QVERIFY(frame->positions.empty());
}

void tst_Runner::settingsThatNoSimulationCanRunWithGiveAMessage() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    std::uint64_t generation = 0;
    for (const double frameStep : {-1.0, 0.0, 2.0, std::numeric_limits<double>::quiet_NaN()}) {
        scene.settings.frameStep = frameStep;
        runner.setScene(scene, ++generation);
        const auto frame = waitForFrame(runner, [&](const Frame& f) { return f.generation == generation; });
        QVERIFY(frame && frame->message.find("Expected") != std::string::npos);
    }
}

void tst_Runner::aGarmentGoesOnAfterASceneThatCannotBeBuilt() {
    Runner runner;
    const Scene scene = twoSquares(0.05);
    Scene wrong = scene;
    wrong.pattern.seams[0].sides[0][0].edge = pattern::EdgeId("none");
    runner.setScene(scene, 1);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& f) { return f.time > 0.05; }));
    runner.setScene(wrong, 2);
    QVERIFY(waitForFrame(runner, [](const Frame& f) { return f.generation == 2 && !f.message.empty(); }));
    QVERIFY(!runner.isPlaying());
    runner.step(); // nothing to be stepped
    runner.setScene(scene, 3);
    const auto frame = waitForFrame(runner, [](const Frame& f) { return f.generation == 3; });
    QVERIFY(frame && frame->time > 0.05);
}

void tst_Runner::aGarmentAtRestSleepsUntilSomethingChanges() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    scene.pattern.seams.clear();
    scene.settings.gravity = {};
    runner.setScene(scene, 1);
    runner.play();
    const auto sleeps = [&] { return QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000); };
    QVERIFY(sleeps());
    const auto resting = runner.takeFrame();
    QVERIFY(resting && resting->atRest);
    QVERIFY(runner.isPlaying()); // it would go on if there were something to do

    runner.play(); // asked again, it goes on for a while
    QVERIFY(sleeps());
    const auto pushed = runner.takeFrame();
    QVERIFY(pushed && pushed->time >= resting->time + 0.5);

    scene.settings.gravity = {0, -9.81, 0}; // an edit
    runner.setScene(scene, 2);
    QVERIFY(runner.isBusy());
    QVERIFY(waitForFrame(runner, [&](const Frame& f) { return f.generation == 2 && f.time > pushed->time + 0.1; }));
    runner.pause();
    QVERIFY(sleeps());
}

void tst_Runner::aHandWakesAGarmentAtRest() {
    Runner runner;
    runner.setScene(twoSquares(0.05), 1);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& f) { return f.atRest; }));
    QVERIFY(QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000));
    runner.hold({{.piece = "left", .material = {0.1, 0.1}, .target = {-0.1, 1.2, 0.1}}});
    QVERIFY(waitForFrame(runner, [](const Frame& f) {
        return std::ranges::any_of(f.positions, [](const Vec3& p) { return p.z > 0.08; });
    }));
}

void tst_Runner::aGarmentAtRestIsFinishedByStatics() {
    Runner runner;
    runner.finishAtRest(true);
    runner.setScene(twoSquares(0.05), 1);
    runner.play();
    const auto finished = waitForFrame(runner, [](const Frame& f) { return f.finish == Finish::found; });
    QVERIFY(finished && finished->atRest);
    QVERIFY(finished->finishMove > 0);
    QVERIFY(QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000));
    QVERIFY(runner.isPlaying());
    QVERIFY(!runner.takeFrame()); // once, not again and again

    runner.hold({{.piece = "left", .material = {0.1, 0.1}, .target = {-0.1, 1.2, 0.1}}});
    QVERIFY(waitForFrame(runner, [](const Frame& f) { return f.finish == Finish::none && !f.atRest; }));
    runner.finishAtRest(false);
    runner.hold({});
    QVERIFY(QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000));
    const auto resting = runner.takeFrame();
    QVERIFY(resting && resting->atRest && resting->finish == Finish::none);
}

/// All corners along the seam are pinned, 0.2 m apart.
void tst_Runner::whatIsWrongWithItIsSaidThen() {
    Scene scene = twoSquares(0.05);
    for (const auto& [piece, vertex] : {std::pair{"left", "v1"}, {"left", "v2"}, {"right", "v0"}, {"right", "v3"}})
        scene.pattern.pins.push_back(
            {pattern::PinId(std::string(piece) + vertex), pattern::PieceId(piece), pattern::VertexId(vertex)});
    Runner runner;
    runner.finishAtRest(true);
    runner.setScene(scene, 1);
    runner.play();
    std::size_t before = 0; // what is said while it is not at rest
    const auto finished = waitForFrame(runner, [&](const Frame& f) {
        if (f.finish == Finish::none) before += f.warnings.size();
        return f.finish == Finish::found || f.finish == Finish::notFound;
    });
    QVERIFY(finished);
    QCOMPARE(before, std::size_t(0));
    QCOMPARE(finished->warnings.size(), std::size_t(1));
    QCOMPARE(finished->warnings[0].place, std::string("seam \"middle\""));
    QVERIFY(finished->warnings[0].text.starts_with("The seam is not closed; its gap is 200.0 mm"));
}

void tst_Runner::theWayToTheEquilibriumHasNoJumps() {
    Runner runner;
    runner.finishAtRest(true);
    Scene scene;
    scene.settings.gravity.y *= 7; // millimetres of what few substeps leave soft
    scene.settings.damping = 2;
    scene.pattern.fabrics.push_back(plainCloth());
    pattern::Piece sheet = polygonPiece("sheet", {{0, 0}, {0.1, 0}, {0.1, 0.5}, {0, 0.5}}, 0.01);
    sheet.placement = pattern::Placement{};
    sheet.placement->transform.origin = {0, 1, 0};
    scene.pattern.pieces.push_back(std::move(sheet));
    for (const char* corner : {"v2", "v3"})
        scene.pattern.pins.push_back({pattern::PinId(corner), pattern::PieceId("sheet"), pattern::VertexId(corner)});
    runner.setScene(scene, 1);
    runner.play();
    std::vector<Vec3> last;
    double whole = 0, most = 0;
    (void)waitForFrame(runner, [&](const Frame& f) {
        if (f.finish != Finish::none && !last.empty())
            for (std::size_t v = 0; v < last.size(); ++v)
                most = std::max(most, geometry::distance(last[v], f.positions[v]));
        last = f.positions;
        whole = f.finishMove;
        return f.finish == Finish::found;
    });
    QVERIFY2(whole > 2e-3, qPrintable(QString::number(1000 * whole)));
    QVERIFY2(most < 0.7 * whole, qPrintable(QString::number(most / whole))); // pictures may be missed, not all of them
}

void tst_Runner::everyOrderStopsStatics_data() {
    QTest::addColumn<std::function<void(Runner&)>>("order");
    QTest::newRow("pause") << std::function<void(Runner&)>([](Runner& runner) { runner.pause(); });
    QTest::newRow("a hand") << std::function<void(Runner&)>([](Runner& runner) {
        runner.hold({{.piece = "left", .material = {0.1, 0.1}, .target = {-0.1, 1.2, 0.1}}});
    });
    QTest::newRow("an edit") << std::function<void(Runner&)>(
        [](Runner& runner) { runner.setScene(twoSquares(0.006), 2); });
    QTest::newRow("no more of it") << std::function<void(Runner&)>([](Runner& runner) { runner.finishAtRest(false); });
}

void tst_Runner::everyOrderStopsStatics() {
    QFETCH(std::function<void(Runner&)>, order);
    Runner runner;
    runner.finishAtRest(true);
    runner.setScene(twoSquares(0.006), 1);
    runner.play();
    const auto rested = waitForFrame(runner, [](const Frame& f) { return f.finish == Finish::underWay; });
    QVERIFY(rested);
    order(runner);
    // A garment that was edited lies again within some 30 ms, and only the newest frame is kept: its next statics may
    // be the first that is seen of it.
    const auto stopped = waitForFrame(
        runner, [&](const Frame& f) { return f.finish == Finish::none || f.generation != rested->generation; });
    QVERIFY(stopped);
    if (stopped->time == rested->time && stopped->generation == rested->generation)
        QVERIFY(stopped->positions == rested->positions); // where it rested, not on the way
}

namespace {

Checkpoint checkpointOf(Runner& runner) {
    runner.askForCheckpoint();
    std::optional<Result<Checkpoint>> checkpoint;
    (void)QTest::qWaitFor([&] { return (checkpoint = runner.takeCheckpoint()).has_value(); }, 60000);
    if (!checkpoint || !*checkpoint) qFatal("no checkpoint");
    return std::move(**checkpoint);
}

} // namespace

void tst_Runner::aCheckpointIsGoneOnFromByAnotherRunner() {
    Runner runner, another;
    runner.setScene(twoSquares(0.05), 1);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.time > 0.1; }));
    runner.pause();
    const Checkpoint checkpoint = checkpointOf(runner);
    QVERIFY(checkpoint.time > 0.1);
    another.setScene(twoSquares(0.05), 1);
    another.resume(checkpoint);
    for (Runner* each : {&runner, &another}) each->step();
    const auto later = [&](const Frame& frame) { return frame.time > checkpoint.time; };
    const auto here = waitForFrame(runner, later), there = waitForFrame(another, later);
    QVERIFY(here && there);
    QCOMPARE(there->time, here->time);
    QVERIFY(there->positions == here->positions);
    QVERIFY(!another.isPlaying());
}

void tst_Runner::aCheckpointOfAnotherSceneIsRefused() {
    Runner runner, another;
    runner.setScene(twoSquares(0.05), 1);
    another.setScene(twoSquares(0.04), 1);
    QVERIFY(waitForFrame(another, [](const Frame& frame) { return !frame.positions.empty(); }));
    another.resume(checkpointOf(runner));
    const auto refused = waitForFrame(another, [](const Frame& frame) { return !frame.message.empty(); });
    QVERIFY(refused);
    QVERIFY(refused->message.find("another scene") != std::string::npos);
    QVERIFY(!refused->positions.empty()); // the garment stays
}

void tst_Runner::theBodyMovesAndClothThatRestedGoesAlong() {
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

void tst_Runner::aMotionThatIsRefusedIsSaidAndMovesNothing() {
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
void tst_Runner::anotherMethodTakesOver() {
    const std::vector<Vec3> fast = fallenBy(dynamics::Method::xpbd), again = fallenBy(dynamics::Method::xpbd),
                            euler = fallenBy(dynamics::Method::backwardEuler);
    QVERIFY(fast == again);
    const double apart = geometry::distance(fast[0], euler[0]);
    QVERIFY2(apart > 1e-4 && apart < 0.02, qPrintable(QString::number(apart)));
}

void tst_Runner::aMethodWaitsUntilTheBodyStandsStill() {
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

namespace {

const std::vector<Grip> pinnedCorner{{.piece = "left", .material = {0, 0}, .target = {-0.3, 1, 0}}};

bool hangs(const Frame& frame) {
    return std::ranges::max(frame.positions, {}, &Vec3::y).y > 0.8;
}

} // namespace

/// A square of two that fall holds on to a pin.
void tst_Runner::handsHoldAcrossACheckpoint() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    scene.pattern.seams.clear();
    scene.settings.gravity = {0, -9.81, 0};
    runner.setScene(scene, 1);
    runner.hold(pinnedCorner);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.time > 0.1; }));
    runner.pause();
    runner.resume(checkpointOf(runner));
    runner.play();
    const auto later = waitForFrame(runner, [](const Frame& frame) { return frame.time > 1; });
    QVERIFY(later && hangs(*later));
}

void tst_Runner::aHandThatLetsGoOfABrokenSceneHoldsNoMore() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    scene.pattern.seams.clear();
    scene.settings.gravity = {0, -9.81, 0};
    Scene wrong = scene;
    wrong.settings.frameStep = -1;
    runner.setScene(scene, 1);
    runner.hold(pinnedCorner);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.time > 0.1; }));
    runner.setScene(wrong, 2);
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.generation == 2; }));
    runner.hold({});
    QVERIFY(QTest::qWaitFor([&] { return !runner.isBusy(); }, 60000));
    runner.setScene(scene, 3);
    runner.play();
    const auto later = waitForFrame(runner, [](const Frame& frame) { return frame.generation == 3 && frame.time > 1; });
    QVERIFY(later && !hangs(*later));
}

void tst_Runner::fiveHundredEditsWhileItSews() {
    Runner runner;
    std::mt19937 random(1234);
    std::uniform_real_distribution<double> shift(-0.01, 0.01);
    Scene scene = twoSquares(0.05);
    runner.setScene(scene, 1);
    runner.play();
    for (std::uint64_t generation = 2; generation <= 501; ++generation) {
        pattern::Piece piece = *scene.pattern.pieces[generation % 2];
        const std::size_t vertex = generation % 2 == 0 ? (random() % 2) * 3 : 1 + random() % 2; // not the seam's
        const Vec2 corner{vertex == 1 || vertex == 2 ? 0.2 : 0.0, vertex >= 2 ? 0.2 : 0.0};
        piece.outline.vertices[vertex].position = corner + Vec2{shift(random), shift(random)};
        scene.pattern.pieces[generation % 2] = piece;
        runner.setScene(scene, generation);
        if (generation % 3 == 0)
            runner.hold({{.piece = "left", .material = {0.1, 0.1}, .target = {-0.2 + shift(random), 1.1, 0}}});
        if (generation % 20 == 0) runner.hold({});
        if (generation % 50 == 0) runner.reset();
        if (generation % 50 == 1) runner.play();
        (void)runner.takeFrame();
        if (generation % 5 == 0) QTest::qWait(2); // lets some scenes be sewn, not only replaced
    }
    const auto frame = waitForFrame(runner, [](const Frame& f) { return f.generation == 501; });
    QVERIFY(frame);
    QVERIFY(!frame->positions.empty());
    for (const Vec3& p : frame->positions) QVERIFY(geometry::isFinite(p));
}

QTEST_GUILESS_MAIN(tst_Runner)
#include "tst_Runner.moc"
