// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/Simulation.h"
#include "tests/Suite.h"
#include "tests/dynamics/DenseSink.h"
#include "tests/simulation/Sewn.h"

#include <QTest>
#include <algorithm>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double clothSide = 0.2; // of the square [m]

/// A square of cloth, level, half a metre and a little over the floor.
Scene levelSquare(double gravity = 0) {
    Scene scene = twoSquares(0.02);
    scene.settings.gravity = {0, -gravity, 0};
    scene.pattern.pieces.pop_back();
    scene.pattern.seams.clear();
    pattern::Piece piece = *scene.pattern.pieces[0];
    piece.placement->transform = {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {-0.1, 0.51, 0.1}};
    scene.pattern.pieces[0] = piece;
    return scene;
}

Grip gripAt(Vec2 material, const Vec3& target) {
    return {.piece = "left", .material = material, .target = target};
}

/// The node of this material point.
Vec3 placeOf(const Simulation& simulation, Vec2 material) {
    const auto& nodes = simulation.garment().mesh->pieces[0].material;
    const auto found = std::ranges::min_element(nodes, {}, [&](Vec2 p) { return distance(p, material); });
    return simulation.nodePositions()[found - nodes.begin()];
}

constexpr Vec2 middle{clothSide / 2, clothSide / 2};

} // namespace

/// Hands that hold the cloth while it is simulated.
class tst_Grips : public QObject {
    Q_OBJECT
private slots:
    void withoutAHandThereIsNoStage();
    void theHeldPlaceFollowsTheHand();
    void theHandGoesNoFasterThanItsSpeed();
    void aHugeJumpOfTheHandIsSurvived();
    void theForceIsThatOfTheWeightItCarries();
    void theForceIsTheSlopeOfTheEnergy();
    void clothIsNotDraggedThroughTheBody();
    void whatIsLetGoFalls();
    void aGripOutlivesAnEdit();
    void aGripOfAPieceThatIsGoneHoldsNothing();
    void aGripFinerThanTheMeshHoldsTheNextNode();
};

void tst_Grips::withoutAHandThereIsNoStage() {
    auto simulation = Simulation::create(levelSquare());
    QVERIFY(simulation);
    const auto leftOut = [&] {
        return std::ranges::count(simulation->plan().leftOut(), "hands", &LeftOut::stage) == 1;
    };
    QVERIFY(leftOut() && !simulation->plan().find("hands"));
    simulation->hold({gripAt(middle, {0, 1, 0})});
    QVERIFY(!leftOut() && simulation->plan().find("hands"));
    simulation->hold({});
    QVERIFY(leftOut() && !simulation->plan().find("hands"));
}

void tst_Grips::theHeldPlaceFollowsTheHand() {
    Scene scene = levelSquare();
    scene.settings.damping = 5;
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    const Vec3 target{0.1, 0.61, 0.05};
    simulation->hold({gripAt(middle, {0, 0.51, 0})});
    run(*simulation, 2);
    for (int i = 1; i <= 60; ++i) { // only the target moves: the same stage goes on
        const dynamics::Stage* stage = simulation->plan().find("hands");
        simulation->hold({gripAt(middle, lerp(Vec3{0, 0.51, 0}, target, i / 60.0))});
        QCOMPARE(simulation->plan().find("hands"), stage);
        run(*simulation, 1);
    }
    run(*simulation, 120);
    const Vec3 place = placeOf(*simulation, middle);
    QVERIFY2(distance(place, target) < 0.002, qPrintable(QString::number(distance(place, target))));
}

void tst_Grips::theHandGoesNoFasterThanItsSpeed() {
    auto simulation = Simulation::create(levelSquare());
    QVERIFY(simulation);
    Grip grip = gripAt(middle, {0, 2.51, 0}); // two metres higher
    grip.speed = 1;
    simulation->hold({grip});
    run(*simulation, 60); // one second
    const double risen = placeOf(*simulation, middle).y - 0.51;
    QVERIFY2(risen > 0.9 && risen < 1.02, qPrintable(QString::number(risen)));
}

void tst_Grips::aHugeJumpOfTheHandIsSurvived() { // S27 of the stability suite
    Scene scene = levelSquare(9.81);
    for (const char* corner : {"v0", "v1", "v2", "v3"})
        scene.pattern.pins.push_back({pattern::PinId(corner), pattern::PieceId("left"), pattern::VertexId(corner)});
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    run(*simulation, 30);
    const Vec3 before = placeOf(*simulation, middle);
    simulation->hold({gripAt(middle, {0, 10.5, 0})});
    run(*simulation, 60);
    for (const Vec3& p : simulation->nodePositions()) {
        QVERIFY(geometry::isFinite(p));
        QVERIFY2(p.y < 0.51 + clothSide, qPrintable(QString::number(p.y)));
    }
    simulation->hold({});
    run(*simulation, 600);
    const double off = distance(placeOf(*simulation, middle), before);
    QVERIFY2(off < 0.01, qPrintable(QString::number(off)));
}

void tst_Grips::theForceIsThatOfTheWeightItCarries() {
    auto simulation = Simulation::create(levelSquare(9.81));
    QVERIFY(simulation);
    Grip grip = gripAt(middle, {0, 0.51, 0});
    grip.strength = 1; // the sheet weighs 0.06 N: the fingers yield by less than a millimetre
    simulation->hold({grip});
    run(*simulation, 180);
    const auto settled = simulation->settle({});
    QVERIFY(settled && settled->newton.converged);
    const auto& mass = simulation->garment().model.mass;
    std::vector<Vec3> forces(mass.size());
    simulation->plan().find("hands")->addForces(simulation->state().positions, forces);
    Vec3 carried;
    double weight = 0;
    for (std::size_t p = 0; p < mass.size(); ++p) {
        carried += forces[p];
        weight += mass[p] * 9.81;
    }
    QVERIFY2(distance(carried, {0, weight, 0}) < 1e-3 * weight, qPrintable(QString::number(carried.y / weight)));
}

void tst_Grips::theForceIsTheSlopeOfTheEnergy() {
    auto simulation = Simulation::create(levelSquare());
    QVERIFY(simulation);
    simulation->hold({gripAt(middle, {0.004, 0.513, 0}), gripAt({0.05, 0.05}, {0.2, 0.7, 0.1})}); // near and far
    dynamics::ParticleState state = simulation->state();
    auto* hands = simulation->plan().find("hands");
    hands->beginStep(state, 10); // the hands are at their targets
    const int n = static_cast<int>(state.positions.size());
    std::vector<Vec3> forces(n);
    hands->addForces(state.positions, forces);
    fixtures::DenseSink hessian(n);
    hands->addHessian(state.positions, hessian);
    constexpr double h = 1e-6;
    for (int p = 0; p < n; p += 7)
        for (int axis = 0; axis < 3; ++axis) {
            auto moved = state.positions;
            moved[p][axis] += h;
            const double above = hands->energy(moved);
            std::vector<Vec3> forcesAbove(n), forcesBelow(n);
            hands->addForces(moved, forcesAbove);
            moved[p][axis] -= 2 * h;
            const double below = hands->energy(moved);
            hands->addForces(moved, forcesBelow);
            QVERIFY(std::abs((below - above) / (2 * h) - forces[p][axis]) < 1e-6);
            const double slope = (forcesBelow[p][axis] - forcesAbove[p][axis]) / (2 * h);
            const double entry = hessian.values[(3 * p + axis) * hessian.size + 3 * p + axis];
            QVERIFY2(std::abs(slope - entry) < 1e-4 * (1 + std::abs(entry)),
                     qPrintable(QString("%1 %2").arg(slope).arg(entry)));
        }
}

void tst_Grips::clothIsNotDraggedThroughTheBody() {
    Scene scene = levelSquare(9.81);
    scene.body = Shared<body::Body>(box()); // its top is at 0.5 m
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    run(*simulation, 30);
    simulation->hold({gripAt(middle, {0, 0.1, 0})});
    run(*simulation, 60);
    double lowest = 1;
    for (const Vec3& p : simulation->nodePositions()) lowest = std::min(lowest, p.y);
    QVERIFY2(lowest > 0.5, qPrintable(QString::number(lowest)));
}

void tst_Grips::whatIsLetGoFalls() {
    auto simulation = Simulation::create(levelSquare(9.81));
    QVERIFY(simulation);
    simulation->hold({gripAt(middle, {0, 0.51, 0})});
    run(*simulation, 60);
    QVERIFY(placeOf(*simulation, middle).y > 0.5);
    simulation->hold({});
    run(*simulation, 15);
    QVERIFY(placeOf(*simulation, middle).y < 0.3); // g t²/2 = 0.31 m
}

void tst_Grips::aGripOutlivesAnEdit() {
    Scene scene = levelSquare(9.81);
    auto before = Simulation::create(scene);
    QVERIFY(before);
    before->hold({gripAt(middle, {0, 0.51, 0})});
    run(*before, 30);
    pattern::Piece piece = *scene.pattern.pieces[0];
    piece.outline.vertices[2].position += Vec2{0.02, 0.01};
    scene.pattern.pieces[0] = piece;
    auto after = Simulation::continued(scene, *before);
    QVERIFY(after);
    run(*after, 60);
    const double off = distance(placeOf(*after, middle), {0, 0.51, 0});
    QVERIFY2(off < 0.015, qPrintable(QString::number(off))); // a cell is 20 mm
}

void tst_Grips::aGripOfAPieceThatIsGoneHoldsNothing() {
    auto simulation = Simulation::create(levelSquare(9.81));
    QVERIFY(simulation);
    Grip grip = gripAt(middle, {0, 0.51, 0});
    grip.piece = "none";
    simulation->hold({grip});
    run(*simulation, 15);
    QVERIFY(placeOf(*simulation, middle).y < 0.3);
}

void tst_Grips::aGripFinerThanTheMeshHoldsTheNextNode() {
    auto simulation = Simulation::create(levelSquare(9.81));
    QVERIFY(simulation);
    Grip grip = gripAt({0.093, 0.107}, {0, 0.51, 0});
    grip.radius = 1e-4;
    simulation->hold({grip});
    run(*simulation, 60);
    QVERIFY(placeOf(*simulation, middle).y > 0.5);
}

TOILE_TEST(tst_Grips, QCoreApplication)
#include "tst_Grips.moc"
