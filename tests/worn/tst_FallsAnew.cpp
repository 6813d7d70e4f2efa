// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h"
#include "core/simulation/Inspect.h"
#include "samples/Shirt.h"
#include "tests/Suite.h"
#include "tests/simulation/RunnerFixture.h"

using namespace toile;
using namespace toile::simulation;

namespace {

const Scene& coarseBlouse() {
    static const Scene scene = onBlouseWearer(blouseAt(0.028));
    return scene;
}

/// The hem 10 mm longer at the centre front.
Scene longer(Scene scene) {
    pattern::Piece front = *scene.pattern.pieces[0];
    front.outline.vertices[0].position.y -= 0.01;
    scene.pattern.pieces[0] = front;
    return scene;
}

void runToRest(Simulation& simulation) {
    for (int frame = 0; frame < 1200 && !simulation.frame().atRest; ++frame) run(simulation, 1);
}

Simulation worn() {
    Simulation simulation = simulationOf(coarseBlouse());
    runToRest(simulation);
    return simulation;
}

Simulation edited(const Simulation& before, const Scene& scene) {
    auto after = Simulation::continued(scene, before, {}, GoesOn::asSewn);
    if (!after) qFatal("%s", toString(after.error()).c_str());
    return std::move(*after);
}

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, geometry::distance(a[i], b[i]));
    return most;
}

double rootMeanSquare(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += squaredLength(a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

Grip somewhere() {
    return {.piece = coarseBlouse().pattern.pieces[0]->id.value, .material = {0.05, 0.1}, .target = {0, 1, 0.3}};
}

} // namespace

/// A worn garment that is edited falls into place from where it was sewn, and frames show it where it lay.
class tst_FallsAnew : public QObject {
    Q_OBJECT
private slots:
    void theDrapeIsSeenUntilItRests();
    void anEditOnTheWayBeginsAnew();
    void anEditBeforeItsFirstStepAsWell();
    void aHandTakesItWhereItIsSeen();
    void whatElseMovedItIsKept_data();
    void whatElseMovedItIsKept();
    void whatIsNoMereChangeGoesOnAsItLies_data();
    void whatIsNoMereChangeGoesOnAsItLies();
    void aShirtFallsAnewWithItsSeamsClosed();
    void theBodyWaitsForIt();
    void aRunnerShowsTheWay();
    void aStepIsSeen();
};

void tst_FallsAnew::theDrapeIsSeenUntilItRests() {
    const Scene scene = longer(coarseBlouse());
    const Simulation before = worn();
    const auto asItLay = Simulation::continued(scene, before);
    QVERIFY(asItLay && !asItLay->fallsUnseen());
    Simulation after = edited(before, scene);
    QVERIFY(after.fallsUnseen());
    const std::vector<Vec3> seen = after.frame().positions;
    QVERIFY(farthest(seen, asItLay->nodePositions()) < 0.005); // but for seams that are not merged yet
    QVERIFY(farthest(seen, after.nodePositions()) > 0.01);     // sewn without weight, it lay otherwise
    int frames = 0;
    for (; after.fallsUnseen() && frames < 600; ++frames) {
        QVERIFY(after.frame().positions == seen);
        QVERIFY(!after.frame().atRest);
        run(after, 1);
    }
    QVERIFY2(after.frame().atRest, qPrintable(QString::number(frames)));
    QVERIFY(after.frame().positions == after.nodePositions());
    QVERIFY(after.frame().positions != seen);
}

void tst_FallsAnew::anEditOnTheWayBeginsAnew() {
    Simulation once = edited(worn(), longer(coarseBlouse()));
    const std::vector<Vec3> seen = once.frame().positions;
    run(once, 20);
    Simulation twice = edited(once, longer(coarseBlouse()));
    QVERIFY(twice.fallsUnseen());
    QVERIFY(farthest(twice.frame().positions, seen) < 1e-12);
    runToRest(once);
    runToRest(twice);
    const double apart = rootMeanSquare(once.nodePositions(), twice.nodePositions());
    QVERIFY2(apart < 0.001, qPrintable(QString::number(1000 * apart)));
}

/// As while a point is dragged and nothing plays.
void tst_FallsAnew::anEditBeforeItsFirstStepAsWell() {
    const Simulation before = worn();
    const Simulation once = edited(before, longer(coarseBlouse()));
    Simulation back = edited(once, coarseBlouse());
    QVERIFY(back.fallsUnseen());
    runToRest(back);
    const double apart = rootMeanSquare(back.nodePositions(), before.nodePositions()); // the edit is undone
    QVERIFY2(apart < 0.001, qPrintable(QString::number(1000 * apart)));
}

void tst_FallsAnew::aHandTakesItWhereItIsSeen() {
    Simulation after = edited(worn(), longer(coarseBlouse()));
    run(after, 10);
    const std::vector<Vec3> seen = after.frame().positions;
    QVERIFY(farthest(seen, after.nodePositions()) > 0.01);
    after.hold({somewhere()});
    QVERIFY(!after.fallsUnseen());
    QVERIFY(farthest(seen, after.nodePositions()) < 0.005); // sides of seams meet in their middle
    after.hold({});
    QVERIFY(!edited(after, coarseBlouse()).fallsUnseen()); // a hand had it
    runToRest(after);
    QVERIFY(after.frame().atRest);
}

void tst_FallsAnew::whatElseMovedItIsKept_data() {
    QTest::addColumn<std::function<void(Simulation&)>>("move");
    using Move = std::function<void(Simulation&)>;
    QTest::newRow("a hand") << Move([](Simulation& s) {
        s.hold({somewhere()});
        run(s, 5);
        s.hold({});
    });
    QTest::newRow("another method") << Move([](Simulation& s) { s.drapeWith(dynamics::Method::backwardEuler); });
    QTest::newRow("a body that moves") << Move([](Simulation& s) {
        const auto& still = (**coarseBlouse().body).mesh.vertices;
        QVERIFY(s.moveBody(
            std::make_shared<geometry::VertexMotion>(geometry::VertexMotion{.step = 0.1, .poses = {still, still}})));
    });
}

void tst_FallsAnew::whatElseMovedItIsKept() {
    QFETCH(const std::function<void(Simulation&)>, move);
    Simulation before = worn();
    move(before);
    QVERIFY(!edited(before, longer(coarseBlouse())).fallsUnseen());
}

void tst_FallsAnew::whatIsNoMereChangeGoesOnAsItLies_data() {
    QTest::addColumn<std::function<void(Scene&)>>("change");
    using Change = std::function<void(Scene&)>;
    QTest::newRow("a piece that is frozen") << Change([](Scene& scene) {
        pattern::Piece piece = *scene.pattern.pieces[1];
        piece.frozen = true;
        scene.pattern.pieces[1] = piece;
    });
    QTest::newRow("a point that is pinned") << Change([](Scene& scene) {
        const pattern::Piece& piece = *scene.pattern.pieces[0];
        scene.pattern.pins.push_back({pattern::PinId("pin"), piece.id, piece.outline.vertices[0].id});
    });
    QTest::newRow("a piece more") << Change([](Scene& scene) {
        pattern::Piece piece = *scene.pattern.pieces[2];
        piece.id = pattern::PieceId("pocket");
        scene.pattern.pieces.push_back(piece);
    });
    QTest::newRow("a seam less, then again") << Change([](Scene& scene) { scene.pattern.seams.pop_back(); });
    QTest::newRow("another body") << Change([](Scene& scene) { scene.body = Shared<body::Body>(mannequin().body); });
}

void tst_FallsAnew::whatIsNoMereChangeGoesOnAsItLies() {
    QFETCH(const std::function<void(Scene&)>, change);
    Simulation before = worn();
    Scene scene = coarseBlouse();
    change(scene);
    Simulation after = edited(before, scene);
    if (QByteArray(QTest::currentDataTag()) == "a seam less, then again") {
        run(after, 1);
        after = edited(after, coarseBlouse()); // has to be sewn
    }
    QVERIFY(!after.fallsUnseen());
}

/// Its seams close in several orders.
void tst_FallsAnew::aShirtFallsAnewWithItsSeamsClosed() {
    const auto document = samples::shirt(blouseWearer().measurements, blouseWearer().body);
    QVERIFY(document);
    Scene scene{document->pattern, Shared<body::Body>(blouseWearer().body), document->scene};
    Simulation before = simulationOf(scene);
    runToRest(before);
    material::Fabric fabric = *scene.pattern.fabrics[0];
    fabric.arealDensity *= 1.1;
    scene.pattern.fabrics[0] = fabric;
    Simulation after = edited(before, scene);
    QVERIFY(after.fallsUnseen());
    QVERIFY(std::ranges::all_of(after.seams(), &SeamState::merged)); // of two orders
    for (int frame = 0; frame < 600 && !after.frame().atRest; ++frame) {
        run(after, 1);
        QCOMPARE(contactOf(after).selfIntersections, 0);
    }
    const SewReport report = sewn(after);
    QVERIFY2(report.worn->worn, reasonsOf(report).c_str());
    QVERIFY(report.allClosed() && report.allTacked());
    Simulation anew = simulationOf(scene);
    (void)sewn(anew);
    const double apart = rootMeanSquare(after.nodePositions(), anew.nodePositions());
    QVERIFY2(apart < 0.001, qPrintable(QString::number(1000 * apart)));
}

void tst_FallsAnew::theBodyWaitsForIt() {
    Simulation after = edited(worn(), longer(coarseBlouse()));
    while (after.phase() != Phase::draping) run(after, 1);
    QVERIFY(after.fallsUnseen());
    const auto& still = (**coarseBlouse().body).mesh.vertices;
    const auto moved = after.moveBody(
        std::make_shared<geometry::VertexMotion>(geometry::VertexMotion{.step = 0.1, .poses = {still, still}}));
    QVERIFY(!moved && moved.error().text.find("put on") != std::string::npos);
}

void tst_FallsAnew::aRunnerShowsTheWay() {
    Runner runner;
    runner.setScene(coarseBlouse(), 1);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& f) { return f.atRest; }));
    runner.setScene(longer(coarseBlouse()), 2);
    std::vector<Vec3> first, last;
    double most = 0;
    int ways = 0;
    QVERIFY(waitForFrame(runner, [&](const Frame& f) {
        if (f.generation != 2) return false;
        if (first.empty()) first = f.positions;
        if (!last.empty() && f.positions != last) ++ways;
        if (!last.empty()) most = std::max(most, farthest(f.positions, last));
        last = f.positions;
        return f.atRest;
    }));
    const double whole = farthest(first, last);
    QVERIFY2(ways > 2 && most < 0.7 * whole, qPrintable(QString("%1 of %2 mm").arg(1000 * most).arg(1000 * whole)));
}

void tst_FallsAnew::aStepIsSeen() {
    Runner runner;
    runner.setScene(coarseBlouse(), 1);
    runner.play();
    QVERIFY(waitForFrame(runner, [](const Frame& f) { return f.atRest; }));
    runner.pause();
    runner.setScene(longer(coarseBlouse()), 2);
    const auto edited = waitForFrame(runner, [](const Frame& f) { return f.generation == 2; });
    QVERIFY(edited);
    runner.step();
    const auto stepped = waitForFrame(runner, [&](const Frame& f) { return f.time > edited->time; });
    QVERIFY(stepped && farthest(stepped->positions, edited->positions) > 0.01);
}

TOILE_TEST(tst_FallsAnew, QCoreApplication)
#include "tst_FallsAnew.moc"
