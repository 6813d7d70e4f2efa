// SPDX-License-Identifier: GPL-3.0-or-later
#include "RunnerFixture.h"
#include "tests/Suite.h"

using namespace toile;
using namespace toile::simulation;

/// Garments at rest that the simulation's thread takes on to their equilibrium. Run under the thread sanitizer, too.
class tst_RunnerFinish : public QObject {
    Q_OBJECT
private slots:
    void aGarmentAtRestIsFinishedByStatics();
    void whatIsWrongWithItIsSaidThen();
    void whatIsSeenLiesOnTheWayToTheEquilibrium();
    void everyOrderStopsStatics_data();
    void everyOrderStopsStatics();
};

void tst_RunnerFinish::aGarmentAtRestIsFinishedByStatics() {
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
void tst_RunnerFinish::whatIsWrongWithItIsSaidThen() {
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

void tst_RunnerFinish::whatIsSeenLiesOnTheWayToTheEquilibrium() {
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
    std::vector<std::vector<Vec3>> seen;
    const auto found = waitForFrame(runner, [&](const Frame& f) {
        if (f.finish != Finish::none) seen.push_back(f.positions);
        return f.finish == Finish::found;
    });
    QVERIFY(found);
    QVERIFY2(found->finishMove > 2e-3, qPrintable(QString::number(1000 * found->finishMove)));
    const std::vector<Vec3>&first = seen.front(), &last = seen.back();
    for (const std::vector<Vec3>& between : seen) // however many were taken
        for (std::size_t v = 0; v < last.size(); ++v)
            QVERIFY(geometry::distance(first[v], between[v]) + geometry::distance(between[v], last[v]) <
                    geometry::distance(first[v], last[v]) + 1e-9);
}

void tst_RunnerFinish::everyOrderStopsStatics_data() {
    QTest::addColumn<std::function<void(Runner&)>>("order");
    QTest::newRow("pause") << std::function<void(Runner&)>([](Runner& runner) { runner.pause(); });
    QTest::newRow("a hand") << std::function<void(Runner&)>([](Runner& runner) {
        runner.hold({{.piece = "left", .material = {0.1, 0.1}, .target = {-0.1, 1.2, 0.1}}});
    });
    QTest::newRow("an edit") << std::function<void(Runner&)>(
        [](Runner& runner) { runner.setScene(twoSquares(0.006), 2); });
    QTest::newRow("no more of it") << std::function<void(Runner&)>([](Runner& runner) { runner.finishAtRest(false); });
}

void tst_RunnerFinish::everyOrderStopsStatics() {
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

TOILE_TEST(tst_RunnerFinish, QCoreApplication)
#include "tst_RunnerFinish.moc"
