// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/FabricPresets.h"
#include "core/simulation/Sleepers.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"
#include "tests/simulation/Sewn.h"
#include "tests/simulation/SmallScenes.h"

#include <QTest>
#include <cmath>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double frameStep = 1.0 / 60; // [s]

pattern::Piece squareAt(const char* name, double x) {
    pattern::Piece piece = polygonPiece(name, {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0, 0.3}}, 0.03);
    piece.placement = sheetOnTable().pattern.pieces[0]->placement;
    piece.placement->transform.origin.x += x;
    return piece;
}

/// Two sheets: one on the table, and "flag" that far beside it.
Scene twoSheets(double away = 1.5) {
    Scene scene = sheetOnTable();
    scene.pattern.pieces.push_back(squareAt("flag", away));
    return scene;
}

/// The flag hangs by a corner.
Scene sheetAndSwingingFlag() {
    Scene scene = twoSheets();
    scene.pattern.pins.push_back({pattern::PinId("n"), pattern::PieceId("flag"), pattern::VertexId("v0")});
    return scene;
}

/// A hand that leads the flag's middle round and round.
Grip leading(int step, double away = 1.5) {
    const double angle = 0.02 * step;
    return {.piece = "flag",
            .material = {0.15, 0.15},
            .target = {away + 0.05 * std::sin(angle), 0.6, 0.05 * std::cos(angle)}};
}

void lead(Simulation& simulation, int& step, int steps) {
    for (const int end = step + steps; step < end; ++step) {
        simulation.hold({leading(step)});
        run(simulation, 1);
    }
}

bool sheetSleeps(const Simulation& simulation) {
    return std::ranges::any_of(simulation.plan().leftOut(), [](const LeftOut& left) {
        return left.stage == "pieces" && left.why == "they lie still: sheet";
    });
}

bool isOfPieces(const LeftOut& left) {
    return left.stage == "pieces" || left.stage == "frame steps of pieces";
}

/// Leads the flag until the sheet sleeps; the steps that were made.
int leadUntilSheetSleeps(Simulation& simulation) {
    constexpr int most = 900;
    int step = 0;
    while (step < most && !sheetSleeps(simulation)) lead(simulation, step, 1);
    if (step == most) qFatal("the sheet does not sleep");
    return step;
}

/// Two squares that are sewn together, and a third that is not.
pattern::Pattern threeSquares() {
    pattern::Pattern pattern = twoSquares(0.05).pattern;
    pattern.pieces.push_back(squareAt("third", 0));
    return pattern;
}

/// Pieces whose particles are moved one by one.
struct Pieces {
    explicit Pieces(const pattern::Pattern& pattern = threeSquares()) : garment(garmentOf(pattern)) {}

    Garment garment;
    Sleepers sleepers{garment, {}};
    std::vector<Vec3> positions = std::vector<Vec3>(garment.particles.particleCount);

    /// The first particle of a piece moves for so many frames [0.1 m/s]; what others sleep is said after each.
    int changes(int piece, int frames, std::optional<double> reach = {}) {
        int changed = 0;
        for (int i = 0; i < frames; ++i) {
            std::vector<Vec3> next = positions;
            if (piece >= 0) next[garment.particles.particleOf[garment.particles.firstNode[piece]]].x += 0.1 * frameStep;
            changed += sleepers.note(garment, positions, next, frameStep, reach);
            positions = std::move(next);
        }
        return changed;
    }
};

} // namespace

/// Pieces that lie still while others move.
class tst_Sleepers : public QObject {
    Q_OBJECT
private slots:
    void afterASecondOneSleepsWhileAnotherMoves();
    void whatIsSewnTogetherSleepsTogether();
    void whatIsTackedTogetherSleepsTogether();
    void whereAllLieStillNoneSleepsAlone();
    void whoIsNearOneThatMovesStaysAwake();
    void whatSleepsHasNoElements();
    void whatSleepsStaysAndOthersMoveAsIfItWereNotThere();
    void aHandWakesIt();
    void staticsWakeIt();
    void aCheckpointGoesOnToTheSameBits();
    void whatComesNearWakesIt();
    void theReportTellsOfIt();
    void aGarmentHasNoSleepers();
};

void tst_Sleepers::afterASecondOneSleepsWhileAnotherMoves() {
    Pieces squares;
    QCOMPARE(squares.changes(0, 59), 0);
    QCOMPARE(squares.changes(0, 5), 1);
    QCOMPARE(squares.sleepers.pieces(), std::vector<int>{2});
    QVERIFY(squares.sleepers.isAsleep(2) && !squares.sleepers.isAsleep(0));
    QVERIFY(std::abs(squares.sleepers.share() - 121.0 / (121 + 2 * squares.garment.mesh->pieces[0].nodes.size())) <
            1e-12);
    QCOMPARE(squares.changes(0, 100), 0);
    squares.sleepers.wake();
    QVERIFY(squares.sleepers.pieces().empty());
    QCOMPARE(squares.changes(0, 59), 0); // a second begins anew
}

void tst_Sleepers::whatIsSewnTogetherSleepsTogether() {
    Pieces squares;
    QCOMPARE(squares.changes(2, 70), 1);
    QCOMPARE(squares.sleepers.pieces(), (std::vector<int>{0, 1}));
}

void tst_Sleepers::whatIsTackedTogetherSleepsTogether() {
    const Pieces squares;
    const std::vector<TackState> tacks{{.ends = {MeshPoint{.piece = 1}, MeshPoint{.piece = 2}}}};
    Sleepers tacked(squares.garment, tacks);
    std::vector<Vec3> next = squares.positions;
    for (int i = 0; i < 100; ++i) {
        next.front().x += 1;
        QVERIFY(!tacked.note(squares.garment, squares.positions, next, frameStep, {}));
    }
}

void tst_Sleepers::whereAllLieStillNoneSleepsAlone() {
    Pieces squares;
    QCOMPARE(squares.changes(-1, 100), 0);
    QVERIFY(squares.sleepers.pieces().empty());
}

void tst_Sleepers::whoIsNearOneThatMovesStaysAwake() {
    Pieces squares;
    for (Vec3& position : squares.positions) position = {};
    const auto third = [&](double x) {
        for (int k = squares.garment.particles.firstNode[2]; k < std::ssize(squares.positions); ++k)
            squares.positions[k].x = x;
    };
    third(-0.019);
    QCOMPARE(squares.changes(0, 100, 0.02), 0);
    third(-0.021);
    QCOMPARE(squares.changes(0, 1, 0.02), 1);
    QCOMPARE(squares.sleepers.pieces(), std::vector<int>{2});
    third(-0.019);
    QCOMPARE(squares.changes(0, 1, 0.02), 1);
    QVERIFY(squares.sleepers.pieces().empty());
    third(-0.021);
    QCOMPARE(squares.changes(0, 50, 0.02), 0); // it was woken: a second begins anew
}

/// A woven piece with triangles at its border and a knit one lie still, a woven square moves.
void tst_Sleepers::whatSleepsHasNoElements() {
    pattern::Pattern pattern;
    pattern.fabrics = {Shared(plainCloth()), Shared(material::jersey())};
    pattern.pieces.push_back(squareAt("moves", 0));
    const cloth::ClothModel alone = garmentOf(pattern).model;
    pattern.pieces.push_back(polygonPiece("slanted", {{0, 0}, {0.3, 0}, {0.2, 0.3}, {0, 0.3}}, 0.03));
    pattern::Piece knit = squareAt("knit", 1);
    knit.fabric = pattern.fabrics.back()->id;
    pattern.pieces.push_back(std::move(knit));
    Pieces pieces(pattern);
    QCOMPARE(pieces.changes(0, 70), 1);
    QCOMPARE(pieces.sleepers.pieces(), (std::vector<int>{1, 2}));
    const cloth::ClothModel& all = pieces.garment.model;
    const cloth::ClothModel awake = pieces.sleepers.awakeOf(pieces.garment).model;
    const auto isOfTheFirst = [&](auto elements) {
        return !(all.*elements).empty() && (all.*elements).size() > (alone.*elements).size() &&
               (awake.*elements).size() == (alone.*elements).size();
    };
    QVERIFY(isOfTheFirst(&cloth::ClothModel::structural) && isOfTheFirst(&cloth::ClothModel::shear));
    QVERIFY(isOfTheFirst(&cloth::ClothModel::bending));
    QVERIFY(isOfTheFirst(&cloth::ClothModel::triangles) && isOfTheFirst(&cloth::ClothModel::cells));
    QCOMPARE(awake.particleCount(), all.particleCount());
    QCOMPARE(std::ssize(awake.pinned), std::ssize(all.mass) - std::ssize(alone.mass));
}

void tst_Sleepers::whatSleepsStaysAndOthersMoveAsIfItWereNotThere() {
    const Scene scene = sheetAndSwingingFlag();
    Scene flag = scene;
    flag.pattern.pieces.erase(flag.pattern.pieces.begin());
    Simulation both = simulationOf(scene), alone = simulationOf(flag);
    int steps = 0;
    for (; steps < 600 && !sheetSleeps(both); ++steps) run(both, 1);
    QVERIFY2(steps > 60 && steps < 600, qPrintable(QString::number(steps)));
    QCOMPARE(both.stepsSleptApart(), 0.0);
    const std::vector<Vec3> there = nodesOf(both, 0);
    run(both, 120);
    QVERIFY(both.largestSpeed() > 0.01);
    QCOMPARE(nodesOf(both, 0), there);
    QVERIFY(std::abs(both.stepsSleptApart() - 60) < 1e-9); // of 120, without half of the particles
    QVERIFY(both.savedBySleepApart() > 0);
    QCOMPARE(both.sleptTime(), 0.0);
    run(alone, steps + 120);
    QCOMPARE(nodesOf(both, 1), nodesOf(alone, 0));
}

/// Another hand holds the sheet by a corner, where it lies; then it lifts it.
void tst_Sleepers::aHandWakesIt() {
    Simulation simulation = simulationOf(twoSheets());
    run(simulation, 120);
    const Vec3 there = nodesOf(simulation, 0).front();
    Grip corner{.piece = "sheet", .material = {0, 0}, .target = there};
    int step = 0;
    for (; step < 900 && !sheetSleeps(simulation); ++step) {
        simulation.hold({leading(step), corner});
        run(simulation, 1);
    }
    QVERIFY(sheetSleeps(simulation));
    corner.target.y += 0.1;
    simulation.hold({leading(step), corner});
    QVERIFY(!sheetSleeps(simulation));
    run(simulation, 30);
    QVERIFY(geometry::distance(nodesOf(simulation, 0).front(), there) > 0.01);
}

void tst_Sleepers::staticsWakeIt() {
    Simulation simulation = simulationOf(twoSheets());
    (void)leadUntilSheetSleeps(simulation);
    QVERIFY(simulation.settle({.maximumIterations = 0}));
    QVERIFY(!sheetSleeps(simulation));
}

/// All are awake after it, in what goes on as in what is resumed.
void tst_Sleepers::aCheckpointGoesOnToTheSameBits() {
    const Scene scene = twoSheets();
    Simulation simulation = simulationOf(scene);
    int step = leadUntilSheetSleeps(simulation), resumedStep = step;
    const Checkpoint point = simulation.checkpoint();
    QVERIFY(!sheetSleeps(simulation));
    auto resumed = Simulation::resumed(scene, {}, point);
    QVERIFY(resumed);
    resumed->hold({leading(step - 1)}); // as the hand was
    simulation.hold({});
    simulation.hold({leading(step - 1)});
    lead(simulation, step, 120);
    lead(*resumed, resumedStep, 120);
    QVERIFY(sheetSleeps(simulation) && sheetSleeps(*resumed));
    QCOMPARE(resumed->state().positions, simulation.state().positions);
}

/// The flag is led towards the sheet and over it.
void tst_Sleepers::whatComesNearWakesIt() {
    Scene scene = twoSheets();
    scene.settings.selfContact = true;
    Simulation simulation = simulationOf(scene);
    int step = leadUntilSheetSleeps(simulation);
    const auto gap = [&] {
        return std::ranges::min(nodesOf(simulation, 1), {}, &Vec3::x).x -
               std::ranges::max(nodesOf(simulation, 0), {}, &Vec3::x).x;
    };
    QVERIFY(gap() > 0.02);
    for (int i = 0; i < 300 && gap() > 0.02; ++i) {
        QVERIFY(sheetSleeps(simulation));
        simulation.hold({leading(step, 1.5 - 0.01 * i)});
        run(simulation, 1);
    }
    QVERIFY(gap() <= 0.02);
    QVERIFY(!sheetSleeps(simulation));
}

void tst_Sleepers::theReportTellsOfIt() {
    const SewReport report = sewn(sheetAndSwingingFlag(), {.seconds = 4});
    QVERIFY(report.sleptApartSteps > 0 && report.sleptApartSavedSeconds > 0);
    QCOMPARE(std::ranges::count_if(report.leftOut, isOfPieces), 2);
    QCOMPARE(report.leftOut.back().stage, std::string("frame steps of pieces"));
    QCOMPARE(report.leftOut.back().saved, report.sleptApartSavedSeconds);
}

void tst_Sleepers::aGarmentHasNoSleepers() {
    const Scene scene = twoSquares(0.05);
    const SewReport report = sewn(scene, {.seconds = 8});
    QVERIFY(report.allClosed());
    QCOMPARE(report.sleptApartSteps, 0.0);
    QVERIFY(std::ranges::none_of(report.leftOut, isOfPieces));
}

TOILE_TEST(tst_Sleepers)
#include "tst_Sleepers.moc"
