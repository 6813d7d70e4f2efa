// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/SceneMemory.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

/// A sheet that hangs by one edge.
Scene curtain() {
    Scene scene = twoSquares(0.05);
    scene.pattern.pieces.pop_back();
    scene.pattern.seams.clear();
    scene.settings.gravity = {0, -9.81, 0};
    for (const char* corner : {"v2", "v3"})
        scene.pattern.pins.push_back({pattern::PinId(corner), pattern::PieceId("left"), pattern::VertexId(corner)});
    return scene;
}

/// Two sheets that stay where they are, one through the other.
Scene crossedSheets() {
    Scene scene = twoSquares(0.05);
    scene.pattern.seams.clear();
    pattern::Piece left = *scene.pattern.pieces[0], across = *scene.pattern.pieces[1];
    left.frozen = across.frozen = true;
    const Vec3 at = placed(*left.placement, {0.11, 0.01}) - Vec3{0, 0, 0.09};
    across.placement = pattern::Placement{{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}, at}, {}};
    scene.pattern.pieces = {left, across};
    return scene;
}

std::vector<std::string> leftOutOf(const SewReport& report) {
    std::vector<std::string> names;
    for (const LeftOut& left : report.leftOut) names.push_back(left.stage);
    return names;
}

bool holds(const std::vector<std::string>& names, const char* name) {
    return std::ranges::count(names, name) == 1;
}

} // namespace

class tst_Sew : public QObject {
    Q_OBJECT
private slots:
    void twoSquaresReachTheirGoal();
    void aSheetComesToRestAndIsFinished();
    void theFinishCanBeLeftOut();
    void aRunOfSomeSecondsTakesJustThese();
    void theLimitEndsARunThatDoesNotRest();
    void layersThatCrossMissTheGoalOfSelfContactAlone();
    void whatTheSceneDoesNotNeedIsNamedWithAReason();
    void aBodyIsNotLeftOut();
    void withoutLimbsThereIsNoVerdict();
    void equalScenesGiveEqualBits();
    void anotherSceneGivesOtherBits();
    void aStopEndsTheRun();
    void theObserverSeesEveryFrameStep();
    void progressRises();
    void energiesAreThoseOfTheState();
    void anOpenSeamIsWarnedOf();
    void openSeamsOfOneNameAreToldApart();
    void cellsThatCutTheBodyAreWarnedOf();
    void aGarmentThatDoesNotFitInMemoryIsRefusedWithNumbers();
    void aFactorThatDoesNotFitInMemoryIsWarnedOf();
};

void tst_Sew::aGarmentThatDoesNotFitInMemoryIsRefusedWithNumbers() {
    Scene scene = curtain();
    scene.memory = 1'000'000;
    QVERIFY(Simulation::create(scene));
    const auto refused = Simulation::create(scene, {.spacing = 0.001});
    QVERIFY(!refused && refused.error().code == ErrorCode::tooLarge);
    const auto& text = refused.error().text;
    QVERIFY2(text.find(" nodes takes about ") != std::string::npos, text.c_str());
    QVERIFY2(text.find("1 MB are allowed") != std::string::npos, text.c_str());
}

void tst_Sew::aFactorThatDoesNotFitInMemoryIsWarnedOf() {
    Scene scene = curtain();
    const auto ofMemory = [](const SewReport& report) {
        return std::ranges::count(report.warnings, "memory", &Warning::place);
    };
    const SewReport usual = sewn(scene);
    QVERIFY(usual.refusedFactorBytes == 0 && ofMemory(usual) == 0);
    auto whole = Simulation::create(scene);
    QVERIFY(whole);
    scene.memory = estimatedBytes(*whole->garment().mesh); // nothing is left to a factor
    const SewReport bounded = sewn(scene);
    QVERIFY(bounded.refusedFactorBytes > 0);
    QCOMPARE(ofMemory(bounded), 1);
    QVERIFY(bounded.atRest);
}

void tst_Sew::twoSquaresReachTheirGoal() {
    const SewReport report = sewn(twoSquares(0.05));
    QCOMPARE(report.ending, std::string("at rest"));
    QVERIFY(report.allClosed() && report.atRest && report.reachedItsGoal({}));
    QVERIFY(report.restWallSeconds && *report.restWallSeconds > 0 && *report.restWallSeconds <= report.wallSeconds);
    QVERIFY(!sewn(twoSquares(0.05), {.seconds = 0.05}).restWallSeconds);
    QCOMPARE(report.seams[0].state.pairs, 5);
    QVERIFY(std::abs(report.seams[0].state.initialGap - 0.2) < 1e-12);
    QVERIFY(report.seams[0].state.gapAtMerge <= 0.5e-3);
    QCOMPARE(report.seams[0].gap.maximum, 0.0);
    QCOMPARE(report.particles, 2 * 25 - 5);
    QVERIFY(report.warnings.empty());
}

void tst_Sew::aSheetComesToRestAndIsFinished() {
    const SewReport report = sewn(curtain());
    QVERIFY(report.atRest);
    QVERIFY(*report.residual <= 1e-3);
    QVERIFY(*report.finishDisplacementMaximum < 0.005); // the sag of small steps, aimed at 2 mm
    QVERIFY(report.strain.warpMaximum > 0);             // its own weight
    QVERIFY(report.strain.warpMaximum < 0.01);
    QVERIFY(report.simulatedSeconds > 0.5);
}

void tst_Sew::theFinishCanBeLeftOut() {
    const SewReport report = sewn(curtain(), {.finish = false});
    QVERIFY(!report.residual && !report.finishDisplacementMaximum);
}

void tst_Sew::aRunOfSomeSecondsTakesJustThese() {
    const SewSettings settings{.seconds = 0.5};
    const SewReport report = sewn(curtain(), settings);
    QCOMPARE(report.steps, 30);
    QVERIFY(std::abs(report.simulatedSeconds - 0.5) < 1e-9);
    QCOMPARE(report.ending, std::string("time is up"));
    QVERIFY(!report.atRest && !report.residual);
    QVERIFY(report.reachedItsGoal(settings)); // it was not asked to rest
}

void tst_Sew::theLimitEndsARunThatDoesNotRest() {
    Scene scene = curtain();
    scene.settings.damping = 0;
    const SewSettings settings{.limit = 0.3};
    const SewReport report = sewn(scene, settings);
    QCOMPARE(report.ending, std::string("limit reached"));
    QVERIFY(!report.atRest && !report.reachedItsGoal(settings));
}

void tst_Sew::layersThatCrossMissTheGoalOfSelfContactAlone() {
    Scene scene = crossedSheets();
    const SewSettings settings{.seconds = 0.05};
    for (const bool selfContact : {false, true}) {
        scene.settings.selfContact = selfContact;
        const SewReport report = sewn(scene, settings);
        QVERIFY(report.contact.selfIntersections > 0);
        QCOMPARE(report.reachedItsGoal(settings), !selfContact);
        QCOMPARE(*toJson(report).find("contact")->find("layersApart")->asBool(), !selfContact);
    }
}

void tst_Sew::whatTheSceneDoesNotNeedIsNamedWithAReason() {
    const SewReport report = sewn(twoSquares(0.05), {.seconds = 0.05});
    const std::vector<std::string> names = leftOutOf(report);
    for (const char* stage :
         {"body contact", "self-contact", "membrane cells", "membrane triangles", "seam hinges", "slaves", "pins"})
        QVERIFY2(holds(names, stage), stage);
    for (const char* stage : {"springs", "bending", "seams"}) QVERIFY2(!holds(names, stage), stage);
    for (const LeftOut& left : report.leftOut) QVERIFY(!left.why.empty());
    for (const StageShare& stage : report.stages) QVERIFY(stage.name == "seams" || stage.name == "cloth");
}

void tst_Sew::aBodyIsNotLeftOut() {
    Scene scene = twoSquares(0.05);
    scene.body = Shared<body::Body>(box());
    const SewReport report = sewn(scene, {.seconds = 0.05});
    QVERIFY(!holds(leftOutOf(report), "body contact"));
    QCOMPARE(std::ranges::count(report.stages, "body contact", &StageShare::name), 1);
}

void tst_Sew::withoutLimbsThereIsNoVerdict() {
    Scene scene = twoSquares(0.05);
    QVERIFY(!sewn(scene, {.seconds = 0.05}).worn);
    scene.body = Shared<body::Body>(box());
    const SewReport report = sewn(scene, {.seconds = 0.05});
    QVERIFY(!report.worn);
    const Json json = toJson(report);
    QVERIFY(json.find("worn")->find("verdict")->isNull());
    QCOMPARE(json.find("worn")->find("why")->asArray()->size(), std::size_t(1));
}

void tst_Sew::equalScenesGiveEqualBits() {
    QCOMPARE(sewn(twoSquares(0.05)).resultHash, sewn(twoSquares(0.05)).resultHash);
    QCOMPARE(sewn(twoSquares(0.05)).resultHash.size(), std::size_t(64));
}

void tst_Sew::anotherSceneGivesOtherBits() {
    Scene scene = twoSquares(0.05);
    scene.settings.damping += 1e-6;
    QVERIFY(sewn(scene).resultHash != sewn(twoSquares(0.05)).resultHash);
}

void tst_Sew::aStopEndsTheRun() {
    auto simulation = Simulation::create(curtain());
    std::stop_source stop;
    const auto report = sew(*simulation, {}, stop.get_token(), {}, [&](const Simulation& running) {
        if (running.steps() == 3) stop.request_stop();
    });
    QVERIFY(!report);
    QVERIFY(report.error().code == ErrorCode::cancelled);
    QCOMPARE(simulation->steps(), 3);
}

void tst_Sew::theObserverSeesEveryFrameStep() {
    auto simulation = Simulation::create(curtain());
    std::vector<int> seen;
    QVERIFY(sew(*simulation, {.seconds = 0.1}, {}, {},
                [&](const Simulation& running) { seen.push_back(running.steps()); }));
    QCOMPARE(seen, (std::vector<int>{1, 2, 3, 4, 5, 6}));
}

void tst_Sew::progressRises() {
    auto simulation = Simulation::create(curtain());
    std::vector<double> fractions;
    QVERIFY(sew(*simulation, {.seconds = 0.2}, {},
                [&](double fraction, const std::string&) { fractions.push_back(fraction); }));
    QVERIFY(fractions.size() >= 12);
    QVERIFY(std::ranges::is_sorted(fractions));
    QVERIFY(fractions.front() >= 0 && fractions.back() <= 1);
}

void tst_Sew::energiesAreThoseOfTheState() {
    Scene scene = curtain();
    scene.pattern.pins.clear(); // free fall: no cloth is strained
    scene.settings.damping = 0;
    const SewReport report = sewn(scene, {.seconds = 0.5});
    const double mass = 0.15 * 0.2 * 0.2, g = 9.81, fallen = 0.5 * g * 0.25;
    // Small steps of h = 1/60 s over at least one substep fall g·h·t/2 too far and g·h/2 too fast at most.
    QVERIFY(std::abs(report.kineticEnergy / (mass * g * fallen) - 1) < 0.05);
    QVERIFY(std::abs(report.gravityEnergy - mass * g * (1.1 - fallen)) < 0.05 * mass * g * fallen);
    QVERIFY(report.elasticEnergy < 1e-6 * report.kineticEnergy);
}

void tst_Sew::anOpenSeamIsWarnedOf() {
    const SewReport report = sewn(twoSquares(0.05), {.seconds = 0.1});
    QVERIFY(!report.allClosed());
    QCOMPARE(report.warnings.size(), std::size_t(1));
    QCOMPARE(report.warnings[0].place, std::string("seam \"middle\""));
    const Json json = toJson(report);
    const Json& seam = json.find("seams")->asArray()->front();
    QVERIFY(seam.find("gapAtMergeMaximum")->isNull());
    QVERIFY(*seam.find("maximumGap")->asNumber() > 0.1);
}

void tst_Sew::openSeamsOfOneNameAreToldApart() {
    Scene scene = twoSquares(0.05);
    pattern::Seam above = scene.pattern.seams[0];
    above.id = pattern::SeamId("above");
    for (auto& side : above.sides) { // the edges after those that are sewn already, at both pieces
        const pattern::Piece& piece = *pattern::findPiece(scene.pattern, side[0].piece);
        const auto& edges = piece.outline.edges;
        const auto sewn = std::ranges::find(edges, side[0].edge, &pattern::Edge::id);
        side[0].edge = sewn + 1 == edges.end() ? edges.front().id : (sewn + 1)->id;
    }
    scene.pattern.seams.push_back(above);
    const SewReport report = sewn(scene, {.seconds = 0.1});
    const std::string id = scene.pattern.seams[0].id.value;
    QCOMPARE(report.warnings.size(), std::size_t(2));
    QCOMPARE(report.warnings[0].place, "seam \"middle\" (" + id + ")");
    QCOMPARE(report.warnings[1].place, std::string("seam \"middle\" (above)"));
}

/// Cells of 30 mm over the sharp edge of a table: their particles stay 3 mm off.
void tst_Sew::cellsThatCutTheBodyAreWarnedOf() {
    const auto warned = [](const SewReport& report) {
        return std::ranges::count(report.warnings, "body contact", &Warning::place);
    };
    Scene scene = sheetOnTable();
    QCOMPARE(warned(sewn(scene, {.seconds = 1})), 0);
    pattern::Piece piece = *scene.pattern.pieces[0];
    piece.placement->transform.origin.x = 0.33;
    scene.pattern.pieces[0] = piece;
    const SewReport report = sewn(scene, {.seconds = 1});
    QVERIFY(report.contact.bodyIntersections > 0);
    QCOMPARE(warned(report), 1);
}

TOILE_TEST(tst_Sew)
#include "tst_Sew.moc"
