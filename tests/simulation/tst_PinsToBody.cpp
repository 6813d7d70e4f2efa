// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/pattern/PatternPieces.h"
#include "core/simulation/BodyPins.h"
#include "core/simulation/MeshInputOf.h"
#include "core/simulation/Warnings.h"
#include "core/simulation/Wearing.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>
#include <algorithm>

using namespace toile;
using namespace toile::simulation;
using geometry::VertexMotion;

namespace {

enum class Held { inSpace, toBody };

Scene pinned(Scene scene, const std::string& piece, const std::string& vertex, Held held) {
    scene.pattern.pins.push_back({pattern::PinId("pin-" + piece + vertex), pattern::PieceId(piece),
                                  pattern::VertexId(vertex), held == Held::toBody});
    return scene;
}

/// Of a piece of the scene, the particle at a corner.
int particleAt(const Simulation& simulation, int piece, Vec2 corner) {
    const auto& nodes = simulation.garment().mesh->pieces[piece].nodes;
    const auto nearest = std::ranges::min_element(nodes, {}, [&](Vec2 p) { return geometry::distance(p, corner); });
    return simulation.garment().particles.particle({piece, static_cast<int>(nearest - nodes.begin())});
}

constexpr Vec2 v0{0, 0}, v2{0.3, 0.3}; // of the sheet
constexpr int poses = 30;              // one a frame step
constexpr double frameStep = 1.0 / 60; // [s]

/// Half a second in which the body turns by 1 rad about the vertical through the origin and rises by 0.1 m.
Vec3 turned(const Vec3& p, double part) {
    return {std::cos(part) * p.x + std::sin(part) * p.z, p.y + 0.1 * part, std::cos(part) * p.z - std::sin(part) * p.x};
}

template <class At>
std::shared_ptr<const VertexMotion> movedBy(const Scene& scene, At at) {
    VertexMotion motion{frameStep, {}};
    for (int pose = 0; pose <= poses; ++pose) {
        motion.poses.push_back((*scene.body)->mesh.vertices);
        for (Vec3& v : motion.poses.back()) v = at(v, static_cast<double>(pose) / poses);
    }
    return std::make_shared<const VertexMotion>(std::move(motion));
}

void move(Simulation& simulation, const std::shared_ptr<const VertexMotion>& motion) {
    if (const auto moves = simulation.moveBody(motion); !moves) qFatal("%s", toString(moves.error()).c_str());
}

std::string reasonIn(const Simulation& simulation) {
    const auto& left = simulation.plan().leftOut();
    const auto found = std::ranges::find(left, "pins to the body", &LeftOut::stage);
    return found == left.end() ? "" : found->why;
}

double largest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double far = 0;
    for (std::size_t i = 0; i < a.size(); ++i) far = std::max(far, geometry::distance(a[i], b[i]));
    return far;
}

} // namespace

class tst_PinsToBody : public QObject {
    Q_OBJECT
private slots:
    void aFrameKnowsWhatIsPinned() {
        const Scene scene = pinned(pinned(sheetOnTable(), "sheet", "v0", Held::toBody), "sheet", "v2", Held::inSpace);
        const Simulation simulation = simulationOf(scene);
        const auto& pins = simulation.frame().topology->pins; // one piece: a particle is a node
        using Pin = FrameTopology::PinnedVertex;
        QVERIFY(
            (pins == std::vector<Pin>{{particleAt(simulation, 0, v0), true}, {particleAt(simulation, 0, v2), false}}));
    }

    void pinnedClothKeepsItsPlaceOnABodyThatTurns() {
        const Scene scene = pinned(pinned(sheetOnTable(), "sheet", "v0", Held::toBody), "sheet", "v2", Held::inSpace);
        Simulation simulation = simulationOf(scene);
        const int carried = particleAt(simulation, 0, v0), still = particleAt(simulation, 0, v2);
        const Vec3 from = simulation.state().positions[carried], there = simulation.state().positions[still];
        run(simulation, 30);
        QVERIFY(simulation.state().positions[carried] == from); // while the body stands it is a pin like any other
        move(simulation, movedBy(scene, turned));
        for (int pose = 1; pose <= poses; ++pose) {
            run(simulation, 1);
            const Vec3 expected = turned(from, static_cast<double>(pose) / poses);
            QVERIFY(geometry::distance(simulation.state().positions[carried], expected) < 1e-12);
            QVERIFY(simulation.state().positions[still] == there);
            QCOMPARE(simulation.plan().find("pins to the body") != nullptr, simulation.bodyMoves());
        }
        QVERIFY(!simulation.bodyMoves());
        QVERIFY(simulation.state().velocities[carried] == Vec3{});
        const Vec3 to = simulation.state().positions[carried];
        run(simulation, 30);
        QVERIFY(simulation.state().positions[carried] == to);
    }

    /// In no substep it leaps: it goes as the body does, and as fast.
    void itsWayIsContinuous() {
        const Scene scene = pinned(sheetOnTable(), "sheet", "v0", Held::toBody);
        const Simulation simulation = simulationOf(scene);
        const int particle = particleAt(simulation, 0, v0);
        collision::MovingSurface body((*scene.body)->mesh, movedBy(scene, turned), 0);
        std::vector<Vec3> positions = simulation.state().positions;
        BodyPins stage(body, pinnedTo(body, simulation.garment().pinnedToBody, positions));
        const std::vector<double> free(positions.size(), 1.0);
        constexpr int substeps = 50;
        for (int s = 1; s <= substeps; ++s) {
            const std::vector<Vec3> previous = positions;
            const double h = frameStep / substeps;
            dynamics::Substep substep{positions, previous, free, h, s * h};
            stage.project(substep);
            // Poses are joined by straight ways; off its triangle by 10 mm it turns with it.
            const Vec3 start = previous[particle], way = turned(start, 1.0 / poses) - start;
            if (s == 1)
                QVERIFY(geometry::distance(positions[particle], start + way / double(substeps)) < 1e-3 * length(way));
            QVERIFY(std::abs(geometry::distance(previous[particle], positions[particle]) - length(way) / substeps) <
                    1e-2 * length(way) / substeps);
        }
        QVERIFY(largest(positions, simulation.state().positions) > 0);
        for (std::size_t p = 0; p < positions.size(); ++p)
            QVERIFY(static_cast<int>(p) == particle || positions[p] == simulation.state().positions[p]);
    }

    /// Without friction nothing but the pins takes the sheet along; what is not pinned follows.
    void clothBesideThePinsFollows() {
        const auto middleAfter = [](Scene scene) {
            scene.settings.bodyFriction = 0;
            Simulation simulation = simulationOf(scene);
            run(simulation, 30);
            const int middle = particleAt(simulation, 0, {0.15, 0.15});
            const double from = simulation.state().positions[middle].x;
            move(simulation, movedBy(scene, [](const Vec3& p, double part) { return p + Vec3{0.2 * part, 0, 0}; }));
            run(simulation, 120);
            return simulation.state().positions[middle].x - from;
        };
        const Scene loose = sheetOnTable();
        QVERIFY(std::abs(middleAfter(loose)) < 0.005);
        Scene held = loose;
        for (const char* vertex : {"v0", "v1", "v2", "v3"}) held = pinned(held, "sheet", vertex, Held::toBody);
        const double way = middleAfter(held);
        QVERIFY2(std::abs(way - 0.2) < 0.005, qPrintable(QString::number(way)));
    }

    void onABodyThatStandsItIsAnOrdinaryPin() {
        Simulation toBody = simulationOf(pinned(sheetOnTable(0.6), "sheet", "v0", Held::toBody));
        Simulation inSpace = simulationOf(pinned(sheetOnTable(0.6), "sheet", "v0", Held::inSpace));
        run(toBody, 40);
        run(inSpace, 40);
        QVERIFY(toBody.state().positions == inSpace.state().positions);
        QCOMPARE(reasonIn(toBody), std::string("it stands still"));
        QCOMPARE(reasonIn(inSpace), std::string("nothing is pinned to it"));
    }

    void pinsInSpaceNeedNoStageBesideABodyThatMoves() {
        const Scene scene = pinned(sheetOnTable(), "sheet", "v0", Held::inSpace);
        Simulation simulation = simulationOf(scene);
        move(simulation, movedBy(scene, turned));
        run(simulation, 1);
        QVERIFY(simulation.bodyMoves() && !simulation.plan().find("pins to the body"));
        QCOMPARE(reasonIn(simulation), std::string("nothing is pinned to it"));
    }

    void withoutABodyItIsToldOf() {
        Scene scene = pinned(sheetOnTable(), "sheet", "v0", Held::toBody);
        Simulation with = simulationOf(scene);
        QVERIFY(warningsOf(with, contactOf(with)).empty());
        scene.body.reset();
        Simulation without = simulationOf(scene);
        const auto warnings = warningsOf(without, contactOf(without));
        QCOMPARE(warnings.size(), std::size_t(1));
        QCOMPARE(warnings[0].place, std::string("pin \"pin-sheetv0\""));
        QVERIFY(warnings[0].text.find("no body") != std::string::npos);
        QCOMPARE(reasonIn(without), std::string("no body"));
        const Vec3 there = without.state().positions[particleAt(without, 0, v0)];
        run(without, 10);
        QVERIFY(without.state().positions[particleAt(without, 0, v0)] == there);
    }

    void whatIsHeldInSpaceAsWellStays() {
        Scene scene = pinned(pinned(twoSquares(), "left", "v1", Held::toBody), "right", "v0", Held::inSpace);
        scene = pinned(scene, "left", "v2", Held::toBody);
        const auto garment = [&](bool merged) {
            auto mesh = meshing::meshGarment(*meshInputOf(scene.pattern));
            return *makeGarment(scene.pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), {merged});
        };
        QCOMPARE(garment(false).pinnedToBody.size(), std::size_t(2));
        QCOMPARE(garment(false).model.pinned.size(), std::size_t(3));
        QCOMPARE(garment(true).pinnedToBody.size(), std::size_t(1)); // the corner of both squares is held in space
        QCOMPARE(garment(true).model.pinned.size(), std::size_t(2));
        scene.pattern = *pattern::setFrozen(scene.pattern, pattern::PieceId("left"), true);
        QVERIFY(garment(false).pinnedToBody.empty());
    }

    void clothThatIsPinnedOnTheWayIsCarriedFromThere() {
        const Scene loose = sheetOnTable(), held = pinned(loose, "sheet", "v0", Held::toBody);
        Simulation before = simulationOf(loose);
        move(before, movedBy(loose, turned));
        run(before, 10);
        auto simulation = Simulation::continued(held, before);
        QVERIFY(simulation && simulation->bodyMoves());
        const int carried = particleAt(*simulation, 0, v0);
        const Vec3 from = simulation->state().positions[carried];
        // back to where the body began, and on by the whole motion
        const double done = 10.0 / poses;
        const Vec3 first{std::cos(done) * from.x - std::sin(done) * from.z, from.y - 0.1 * done,
                         std::cos(done) * from.z + std::sin(done) * from.x};
        QVERIFY(geometry::distance(turned(first, done), from) < 1e-12);
        run(*simulation, poses - 10);
        QVERIFY(geometry::distance(simulation->state().positions[carried], turned(first, 1)) < 1e-9);
        // and an edit of cloth that is carried leaves it at its place
        auto again = Simulation::continued(held, before);
        run(*again, 7);
        auto edited = Simulation::continued(held, *again);
        run(*edited, poses - 17);
        QVERIFY(geometry::distance(edited->state().positions[carried], turned(first, 1)) < 1e-9);
    }

    void aResumedSimulationCarriesItToTheSameBits() {
        const Scene scene = pinned(sheetOnTable(0.55), "sheet", "v0", Held::toBody);
        Simulation simulation = simulationOf(scene);
        run(simulation, 20);
        const Checkpoint point = simulation.checkpoint();
        auto resumed = Simulation::resumed(scene, {}, point);
        QVERIFY(resumed);
        for (Simulation* one : {&simulation, &*resumed}) {
            move(*one, movedBy(scene, turned));
            run(*one, poses + 10);
        }
        QVERIFY(simulation.state().positions == resumed->state().positions);
        const Scene other = pinned(sheetOnTable(0.55), "sheet", "v0", Held::inSpace);
        QVERIFY(!Simulation::resumed(other, {}, point));
    }

    /// A body rises with a sheet that is pinned to it, well above it, and another one in the way does not give.
    void layersInTheWayHoldItBack() {
        Scene scene = sheetOnTable(0.8);
        scene.settings.selfContact = true;
        pattern::Piece ceiling = polygonPiece("ceiling", {{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}, 0.05);
        ceiling.placement = scene.pattern.pieces[0]->placement;
        ceiling.placement->transform.origin = {-0.25, 0.83, 0.25};
        ceiling.frozen = true;
        scene.pattern.pieces.push_back(std::move(ceiling));
        for (const char* vertex : {"v0", "v1", "v2", "v3"}) scene = pinned(scene, "sheet", vertex, Held::toBody);
        Simulation simulation = simulationOf(scene);
        const auto report = wear(simulation,
                                 movedBy(scene,
                                         [](const Vec3& p, double part) {
                                             return p + Vec3{0, 0.06 * part, 0};
                                         }),
                                 {});
        QVERIFY2(report.has_value(), report ? "" : toString(report.error()).c_str());
        QCOMPARE(report->contact.selfIntersections, 0);
        QVERIFY2(report->offItsPin > 0.025 && report->offItsPin < 0.035,
                 qPrintable(QString::number(report->offItsPin)));
        for (int node = 0; node < std::ssize(simulation.garment().mesh->pieces[0].nodes); ++node)
            QVERIFY(simulation.state().positions[simulation.garment().particles.particle({0, node})].y < 0.83);
    }

    void aPinnedGarmentComesToRestOnTheLastPose() {
        Scene scene = pinned(sheetOnTable(), "sheet", "v0", Held::toBody);
        Simulation simulation = simulationOf(scene);
        QVERIFY(sewn(simulation).atRest);
        const auto report = wear(simulation, movedBy(scene, turned), {});
        QVERIFY2(report.has_value(), report ? "" : toString(report.error()).c_str());
        QVERIFY(report->reachedItsGoal());
        QVERIFY(report->offItsPin < 1e-12);
        QVERIFY(report->contact.bodyIntersections == 0);
    }
};

TOILE_TEST(tst_PinsToBody, QCoreApplication)
#include "tst_PinsToBody.moc"
