// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/pattern/PatternTacks.h"
#include "tests/Suite.h"
#include "tests/dynamics/DenseSink.h"
#include "tests/simulation/Sewn.h"

#include <QTest>
#include <algorithm>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double squareSide = 0.2; // of the squares [m]

/// Two squares that face each other, the right one 50 mm in front, held by their upper corners; nothing is sewn.
Scene twoCurtains(double spacing = 0.02) {
    Scene scene = twoSquares(spacing);
    scene.pattern.seams.clear();
    scene.settings.gravity = {0, -9.81, 0};
    for (std::size_t i = 0; i < 2; ++i) {
        pattern::Piece piece = *scene.pattern.pieces[i];
        piece.placement->transform.origin = {-0.1, 1, 0.05 * static_cast<double>(i)};
        for (const char* corner : {"v2", "v3"})
            scene.pattern.pins.push_back(
                {pattern::PinId(piece.id.value + corner), piece.id, pattern::VertexId(corner)});
        scene.pattern.pieces[i] = piece;
    }
    return scene;
}

pattern::Tack tackAt(Vec2 onLeft, Vec2 onRight) {
    pattern::Tack tack;
    tack.id = pattern::TackId("t1");
    tack.name = "button";
    tack.ends = {{{pattern::PieceId("left"), onLeft}, {pattern::PieceId("right"), onRight}}};
    return tack;
}

/// With a button in the middle, at no node of any mesh.
Scene buttoned(double spacing = 0.02) {
    Scene scene = twoCurtains(spacing);
    scene.pattern.tacks = {tackAt({0.1037, 0.0471}, {0.1037, 0.0471})};
    return scene;
}

/// Four particles, two on either end of a thread of 10 mm that is taut by `gap`.
struct Strand {
    meshing::GarmentMesh mesh;
    ParticleMap particles;
    std::vector<Vec3> positions;
    TackState tack;

    explicit Strand(double gap, bool closed = true) {
        for (int piece = 0; piece < 2; ++piece) {
            meshing::PieceMesh& of = mesh.pieces.emplace_back();
            of.nodes = {{0, 0}, {0.1, 0}, {0, 0.1}};
            of.display = {{0, 1, 2}};
        }
        particles = particleMap(mesh, {});
        tack.length = 0.01;
        tack.closed = closed;
        tack.start = 0;
        tack.ends = {meshPointAt(mesh, 0, {0.03, 0.02}), meshPointAt(mesh, 1, {0.01, 0.06})};
        positions = {{0, 0, 0}, {0.1, 0.01, 0}, {0, 0.1, 0.02}, {0, 0, 0}, {0.1, 0, 0.01}, {0.02, 0.1, 0}};
        const Vec3 way = wayBetween(tack, particles, positions), wanted = Vec3{0, 0.6, 0.8} * (0.01 + gap);
        for (std::size_t p = 3; p < 6; ++p) positions[p] += wanted - way;
    }
    [[nodiscard]] Tacks stage(double maximumForce = 10) const {
        const std::vector<double> mass(6, 1e-3);
        return Tacks(std::span(&tack, 1), particles, 0.6, mass, {.maximumForce = maximumForce});
    }
};

} // namespace

/// Two places of the cloth that a thread holds together.
class tst_Tacks : public QObject {
    Q_OBJECT
private slots:
    void aPlaceIsABlendOfTheNodesRoundIt();
    void aPlaceBeyondTheMeshIsAtItsBorder();

    void theForceIsTheSlopeOfTheEnergy_data();
    void theForceIsTheSlopeOfTheEnergy();
    void theStiffnessIsTheSlopeOfTheForce_data();
    void theStiffnessIsTheSlopeOfTheForce();
    void aLooseThreadDoesNotPush();
    void aSubstepPullsNoHarderThanTheThreadMay();

    void withoutTacksThereIsNoStage();
    void aTackCloses();
    void aTackThatClosesIsReported();
    void itHoldsAnywhereInAnyMesh();
    void aTackHoldsTheWeightOfAFallenSheet();
    void aTackOutlivesAnEditAndAnotherMesh();
    void aTackWaitsForItsOrder();
    void aCheckpointKeepsHowFarATackIs_data();
    void aCheckpointKeepsHowFarATackIs();
    void aBlockedTackStaysOpenAndIsNamed();
    void aTackBesideItsPieceIsRefusedByName();
    void aPleatIsTackedToItself();
    void thePaperHasNoTacks();
};

void tst_Tacks::aPlaceIsABlendOfTheNodesRoundIt() {
    const Simulation simulation = simulationOf(twoSquares(0.03));
    const meshing::GarmentMesh& mesh = *simulation.garment().mesh;
    for (const Vec2 point : {Vec2{0.0371, 0.1113}, Vec2{0, 0}, Vec2{squareSide, 0.05}, Vec2{0.06, 0.06}}) {
        const MeshPoint place = meshPointAt(mesh, 1, point);
        Vec2 blend;
        double weights = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            QVERIFY(place.weights[k] > -1e-8);
            weights += place.weights[k];
            blend += place.weights[k] * mesh.pieces[1].nodes[place.nodes[k]];
        }
        QVERIFY(std::abs(weights - 1) < 1e-12);
        QVERIFY(distance(blend, point) < 1e-12);
    }
}

void tst_Tacks::aPlaceBeyondTheMeshIsAtItsBorder() {
    const Simulation simulation = simulationOf(twoSquares(0.03));
    const meshing::GarmentMesh& mesh = *simulation.garment().mesh;
    const MeshPoint place = meshPointAt(mesh, 0, {squareSide + 0.01, 0.07});
    Vec2 blend;
    for (std::size_t k = 0; k < 3; ++k) blend += place.weights[k] * mesh.pieces[0].nodes[place.nodes[k]];
    QVERIFY(distance(blend, {squareSide, 0.07}) < 1e-12);
}

void tst_Tacks::theForceIsTheSlopeOfTheEnergy_data() {
    QTest::addColumn<double>("gap");
    QTest::addColumn<bool>("closed");
    QTest::newRow("taut") << 0.003 << true;
    QTest::newRow("pulling with all its strength") << 0.02 << true;
    QTest::newRow("still open") << 0.05 << false;
    QTest::newRow("loose") << -0.004 << true;
}

void tst_Tacks::theForceIsTheSlopeOfTheEnergy() {
    QFETCH(double, gap);
    QFETCH(bool, closed);
    const Strand strand(gap, closed);
    const Tacks tacks = strand.stage();
    std::vector<Vec3> forces(6);
    tacks.addForces(strand.positions, forces);
    constexpr double step = 1e-6;
    Vec3 sum;
    for (std::size_t p = 0; p < 6; ++p) {
        sum += forces[p];
        for (int axis = 0; axis < 3; ++axis) {
            auto ahead = strand.positions, behind = strand.positions;
            ahead[p][axis] += step;
            behind[p][axis] -= step;
            const double slope = (tacks.energy(ahead) - tacks.energy(behind)) / (2 * step);
            QVERIFY(std::abs(forces[p][axis] + slope) < 1e-6 * (1 + length(forces[p])));
        }
    }
    QVERIFY(length(sum) < 1e-12);
}

void tst_Tacks::theStiffnessIsTheSlopeOfTheForce_data() {
    theForceIsTheSlopeOfTheEnergy_data();
}

void tst_Tacks::theStiffnessIsTheSlopeOfTheForce() {
    QFETCH(double, gap);
    QFETCH(bool, closed);
    const Strand strand(gap, closed);
    const Tacks tacks = strand.stage();
    fixtures::DenseSink sink(6);
    tacks.addHessian(strand.positions, sink);
    constexpr double step = 1e-7;
    for (int p = 0; p < 6; ++p)
        for (int axis = 0; axis < 3; ++axis) {
            auto ahead = strand.positions, behind = strand.positions;
            ahead[p][axis] += step;
            behind[p][axis] -= step;
            std::vector<Vec3> forward(6), backward(6);
            tacks.addForces(ahead, forward);
            tacks.addForces(behind, backward);
            for (int q = 0; q < 6; ++q)
                for (int other = 0; other < 3; ++other)
                    QVERIFY(std::abs(sink.values[(3 * q + other) * 18 + 3 * p + axis] +
                                     (forward[q][other] - backward[q][other]) / (2 * step)) < 1e-3);
        }
}

void tst_Tacks::aLooseThreadDoesNotPush() {
    Strand strand(-0.004);
    Tacks tacks = strand.stage();
    const std::vector<Vec3> before = strand.positions;
    const std::vector<double> inverseMass(6, 1e3);
    dynamics::Substep substep{strand.positions, before, inverseMass, 1e-3, 2};
    tacks.project(substep);
    QVERIFY(strand.positions == before);
}

void tst_Tacks::aSubstepPullsNoHarderThanTheThreadMay() {
    const std::vector<double> inverseMass(6, 1e3);
    constexpr double h = 1e-3;
    for (const double force : {0.01, 1e6}) {
        Strand strand(0.05, false);
        const std::vector<Vec3> before = strand.positions;
        Tacks tacks = strand.stage(force);
        dynamics::Substep substep{strand.positions, before, inverseMass, h, 2};
        tacks.project(substep);
        Vec3 momentum; // of one end
        for (std::size_t p = 0; p < 3; ++p) momentum += (strand.positions[p] - before[p]) / (inverseMass[p] * h);
        if (force < 1) QVERIFY(length(momentum) <= 4 * force * h * (1 + 1e-9)); // four sweeps
        else QVERIFY(gapBetween(strand.tack, strand.particles, strand.positions) < 1e-12);
    }
}

void tst_Tacks::withoutTacksThereIsNoStage() {
    const auto leftOut = [](const Simulation& simulation) {
        return std::ranges::count(simulation.plan().leftOut(), "tacks", &LeftOut::stage) == 1;
    };
    const Simulation plain = simulationOf(twoCurtains()), tacked = simulationOf(buttoned());
    QVERIFY(leftOut(plain) && !plain.plan().find("tacks"));
    QVERIFY(!leftOut(tacked) && tacked.plan().find("tacks"));
}

void tst_Tacks::aTackCloses() {
    Simulation simulation = simulationOf(buttoned());
    QVERIFY(std::abs(simulation.tacks()[0].initialGap - (0.05 - simulation.tacks()[0].length)) < 1e-9);
    QCOMPARE(simulation.phase(), Phase::sewing);
    run(simulation, 60);
    QVERIFY(simulation.tacks()[0].closed);
    QVERIFY(simulation.phase() != Phase::sewing);
    QVERIFY(simulation.gapOfTack(0) < 1e-3);
}

void tst_Tacks::aTackThatClosesIsReported() {
    const SewReport report = sewn(buttoned());
    QCOMPARE(report.tacks.size(), std::size_t(1));
    QCOMPARE(report.tacks[0].name, std::string("button"));
    QVERIFY(report.tacks[0].closed && report.atRest && report.reachedItsGoal({}));
    QVERIFY2(report.tacks[0].gap < 1e-4, qPrintable(QString::number(report.tacks[0].gap))); // a curtain weighs 0.06 N
    QVERIFY(report.warnings.empty());
}

void tst_Tacks::itHoldsAnywhereInAnyMesh() {
    std::vector<double> heights;
    for (const double spacing : {0.04, 0.02, 0.01}) {
        const SewReport report = sewn(buttoned(spacing));
        QVERIFY2(report.tacks[0].closed && report.atRest, qPrintable(QString::number(spacing)));
        QVERIFY(report.tacks[0].gap < 1e-4);
    }
}

/// The front square hangs by nothing but the button.
void tst_Tacks::aTackHoldsTheWeightOfAFallenSheet() {
    Scene scene = twoCurtains();
    scene.settings.damping = 5; // it swings
    std::erase_if(scene.pattern.pins, [](const pattern::Pin& pin) { return pin.piece.value == "right"; });
    scene.pattern.tacks = {tackAt({0.1, 0.1537}, {0.1, 0.1537})};
    const SewReport report = sewn(scene);
    QVERIFY(report.tacks[0].closed && report.atRest);
    const double weight = 0.15 * squareSide * squareSide * 9.81; // [N]
    const double wanted = weight / TackSettings{}.stiffness;
    QVERIFY2(std::abs(report.tacks[0].gap - wanted) < 0.02 * wanted, qPrintable(QString::number(report.tacks[0].gap)));
}

void tst_Tacks::aTackOutlivesAnEditAndAnotherMesh() {
    Simulation simulation = simulationOf(buttoned());
    run(simulation, 120);
    QVERIFY(simulation.tacks()[0].closed);
    auto after = Simulation::continued(buttoned(0.013), simulation);
    QVERIFY(after);
    QCOMPARE(after->tacks().size(), std::size_t(1));
    QVERIFY(after->gapOfTack(0) < 1e-3);
    run(*after, 2);
    QVERIFY(after->tacks()[0].closed);
    const auto taken = Simulation::continued(twoCurtains(), *after);
    QVERIFY(taken && taken->tacks().empty());
}

void tst_Tacks::aTackWaitsForItsOrder() {
    Scene scene = twoSquares(0.05);
    scene.pattern.tacks = {tackAt({0.05, 0.05}, {0.15, 0.05})};
    scene.pattern.tacks[0].order = 1;
    Simulation simulation = simulationOf(scene);
    while (!simulation.allSeamsMerged()) {
        QVERIFY(simulation.tacks()[0].start < 0);
        run(simulation, 1);
        QVERIFY(simulation.steps() < 200);
    }
    run(simulation, 100);
    QVERIFY(simulation.tacks()[0].closed);
}

void tst_Tacks::aCheckpointKeepsHowFarATackIs_data() {
    QTest::addColumn<int>("frames");
    QTest::newRow("while it closes") << 10;
    QTest::newRow("once it is closed") << 60;
}

void tst_Tacks::aCheckpointKeepsHowFarATackIs() {
    QFETCH(int, frames);
    Simulation simulation = simulationOf(buttoned());
    run(simulation, frames);
    const Checkpoint point = simulation.checkpoint();
    QCOMPARE(point.tacks.size(), std::size_t(1));
    QCOMPARE(point.tacks[0].closed, frames == 60);
    auto resumed = Simulation::resumed(buttoned(), {}, point);
    QVERIFY2(resumed, resumed ? "" : toString(resumed.error()).c_str());
    run(simulation, 50);
    run(*resumed, 50);
    QVERIFY(resumed->state().positions == simulation.state().positions);
    QVERIFY(resumed->tacks()[0].closed);
    Scene moved = buttoned();
    moved.pattern.tacks[0].ends[0].point.x += 0.01;
    QVERIFY(!Simulation::resumed(moved, {}, point) && !Simulation::resumed(twoCurtains(), {}, point));
}

/// A wall of 0.1 m stands between the squares.
void tst_Tacks::aBlockedTackStaysOpenAndIsNamed() {
    Scene scene = twoCurtains();
    pattern::Piece front = *scene.pattern.pieces[1];
    front.placement->transform.origin.z = 0.2;
    scene.pattern.pieces[1] = front;
    body::Body wall;
    wall.name = "wall";
    wall.mesh = shapes::box({-0.5, 0.5, 0.05}, {0.5, 1.5, 0.15});
    scene.body = Shared<body::Body>(std::move(wall));
    scene.pattern.tacks = {tackAt({0.1, 0.1}, {0.1, 0.1})};
    const SewReport report = sewn(scene);
    QVERIFY(!report.tacks[0].closed && !report.reachedItsGoal({}));
    const double asNear = 0.1 + 2 * (scene.settings.skinOffset + 0.2e-3) - (0.4e-3 + TackSettings{}.play);
    constexpr double dent = 1e-3; // of the contact on either side: an open tack pulls weakly
    const double gap = report.tacks[0].gap;
    QVERIFY2(gap < asNear && gap > asNear - 2 * dent, qPrintable(QString::number(gap)));
    QVERIFY(report.atRest && report.contact.outsideBody);
    const auto warned = std::ranges::find(report.warnings, "tack \"button\"", &Warning::place);
    QVERIFY(warned != report.warnings.end() && warned->text.find("not closed") != std::string::npos);
}

void tst_Tacks::aTackBesideItsPieceIsRefusedByName() {
    Scene beside = buttoned(), nowhere = buttoned();
    beside.pattern.tacks[0].ends[1].point.x += squareSide;
    nowhere.pattern.tacks[0].ends[0].piece = pattern::PieceId("collar");
    for (const Scene& scene : {beside, nowhere}) {
        const auto refused = Simulation::create(scene);
        QVERIFY(!refused);
        QCOMPARE(refused.error().place.object, std::string("tack \"button\""));
    }
}

void tst_Tacks::aPleatIsTackedToItself() {
    Scene scene = twoCurtains();
    scene.pattern.pieces.pop_back();
    std::erase_if(scene.pattern.pins, [](const pattern::Pin& pin) { return pin.piece.value == "right"; });
    scene.pattern.tacks = {tackAt({0.08, 0.05}, {0.12, 0.05})};
    scene.pattern.tacks[0].ends[1].piece = pattern::PieceId("left");
    const SewReport report = sewn(scene);
    QVERIFY(report.tacks[0].closed && report.atRest);
}

void tst_Tacks::thePaperHasNoTacks() {
    Scene scene = buttoned();
    scene.paper = true;
    const Simulation simulation = simulationOf(scene);
    QVERIFY(simulation.tacks().empty());
    QVERIFY(std::ranges::count(simulation.plan().leftOut(), "tacks", &LeftOut::stage) == 1);
}

TOILE_TEST(tst_Tacks)
#include "tst_Tacks.moc"
