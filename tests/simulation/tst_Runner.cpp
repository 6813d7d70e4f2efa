// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunnerFixture.h"
#include "core/simulation/SceneCheck.h"
#include "tests/Suite.h"

#include <QTest>
#include <algorithm>
#include <limits>
#include <random>
#include <thread>

using namespace toile;
using namespace toile::simulation;

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
    void whatTheMesherDoesNotAskAboutIsCheckedToo();
    void aGarmentGoesOnAfterASceneThatCannotBeBuilt();
    void aSceneThatCannotBeBuiltDoesNotPlay();
    void anEditIsSeenBeforeAFrameStep();
    void aGarmentAtRestSleepsUntilSomethingChanges();
    void aHandWakesAGarmentAtRest();
    void aCheckpointIsGoneOnFromByAnotherRunner();
    void aCheckpointOfAnotherSceneIsRefused();
    void handsHoldAcrossACheckpoint();
    void aHandThatLetsGoOfABrokenSceneHoldsNoMore();
    void clothMovesWhileEditsComeFasterThanItIsBuilt();
    void fiveHundredEditsWhileItSews();
};

namespace {

/// Two squares, a seam of which names an edge that there is not.
Scene unbuildable() {
    Scene scene = twoSquares(0.05);
    scene.pattern.seams[0].sides[0][0].edge = pattern::EdgeId("none");
    return scene;
}

} // namespace

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
    runner.setScene(unbuildable(), 1);
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

void tst_Runner::whatTheMesherDoesNotAskAboutIsCheckedToo() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    scene.pattern.seams[0].stiffnessFactor = -1;
    runner.setScene(scene, 1);
    const auto frame = waitForFrame(runner, [](const Frame& f) { return !f.message.empty(); });
    QVERIFY(frame);
    QCOMPARE(frame->message, "seam \"middle\": The stiffness factor is -1, but must be positive.");
    QVERIFY(frame->positions.empty());
}

void tst_Runner::aGarmentGoesOnAfterASceneThatCannotBeBuilt() {
    Runner runner;
    const Scene scene = twoSquares(0.05);
    runner.setScene(scene, 1);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& f) { return f.time > 0.05; }));
    runner.setScene(unbuildable(), 2);
    QVERIFY(waitForFrame(runner, [](const Frame& f) { return f.generation == 2 && !f.message.empty(); }));
    QVERIFY(!runner.isPlaying());
    runner.step(); // nothing to be stepped
    runner.setScene(scene, 3);
    const auto frame = waitForFrame(runner, [](const Frame& f) { return f.generation == 3; });
    QVERIFY(frame && frame->time > 0.05);
}

void tst_Runner::aSceneThatCannotBeBuiltDoesNotPlay() {
    Runner runner;
    runner.setScene(unbuildable(), 1);
    const auto refused = waitForFrame(runner, [](const Frame& f) { return !f.message.empty(); });
    QVERIFY(refused);
    for (const auto& order : {&Runner::play, &Runner::step}) {
        (runner.*order)();
        const auto again = waitForFrame(runner, [](const Frame& f) { return !f.message.empty(); });
        QVERIFY(again && again->message == refused->message); // who orders it is told why nothing happens
        QVERIFY(!runner.isPlaying());
    }
    QTRY_VERIFY(!runner.isBusy());
}

void tst_Runner::anEditIsSeenBeforeAFrameStep() {
    Runner runner;
    Scene scene = twoSquares(0.05);
    runner.setScene(scene, 1);
    runner.step();
    const auto stepped = waitForFrame(runner, [](const Frame& frame) { return frame.time > 0; });
    QVERIFY(stepped);

    pattern::Piece longer = *scene.pattern.pieces[0];
    longer.outline.vertices[0].position.y -= 0.02;
    scene.pattern.pieces[0] = longer;
    runner.setScene(scene, 2);
    const auto seen = waitForFrame(runner, [](const Frame& frame) { return frame.generation == 2; });
    QVERIFY(seen);
    QCOMPARE(seen->time, stepped->time);
    QCOMPARE(seen->positions.size(), seen->topology->material.size());
    const auto lowest = [](const Frame& frame) { return std::ranges::min(frame.positions, {}, &Vec3::y).y; };
    QVERIFY(lowest(*seen) < lowest(*stepped) - 0.01);
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
    const auto whole = waitForFrame(runner, [](const Frame& frame) { return frame.generation == 3; });
    QVERIFY(whole);
    runner.play();
    const auto later = waitForFrame(runner, [&](const Frame& frame) { return frame.time > whole->time + 1; });
    QVERIFY(later && !hangs(*later));
}

void tst_Runner::clothMovesWhileEditsComeFasterThanItIsBuilt() {
    Runner runner;
    const Scene scene = twoSquares(0.005); // some milliseconds to build
    runner.setScene(scene, 1);
    runner.play();
    const std::jthread edits([&](std::stop_token stop) {
        for (std::uint64_t generation = 2; !stop.stop_requested(); ++generation) {
            runner.setScene(scene, generation);
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
    });
    QVERIFY(waitForFrame(runner, [](const Frame& frame) { return frame.time > 0.1; }));
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

TOILE_TEST(tst_Runner, QCoreApplication)
#include "tst_Runner.moc"
