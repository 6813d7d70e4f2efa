// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/cloth/FoldAngle.h"
#include "core/simulation/MeshInputOf.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double creasedWidth = 0.12, creasedLength = 0.24; // of the strip [m]

/// A strip with a fold across its middle, or askew; it lies level, weightless, its right side up.
Scene strip(double angle, double factor = 1, double askew = 0) {
    Scene scene;
    scene.settings.gravity = {};
    scene.pattern.fabrics.push_back(plainCloth());
    pattern::Piece piece =
        polygonPiece("strip", {{0, 0}, {creasedLength, 0}, {creasedLength, creasedWidth}, {0, creasedWidth}}, 0.02);
    piece.placement = pattern::Placement{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {0, 1, 0}}, {}};
    pattern::Fold fold;
    fold.id = pattern::FoldId("l1");
    fold.name = "crease";
    fold.ends = {{{pattern::EdgeId("e0"), 0.5 - askew}, {pattern::EdgeId("e2"), 0.5 - askew}}};
    fold.angle = angle;
    fold.stiffnessFactor = factor;
    piece.folds = {fold};
    scene.pattern.pieces.push_back(std::move(piece));
    return scene;
}

} // namespace

class tst_PressedFolds : public QObject {
    Q_OBJECT
private slots:
    void aHingeKnowsWhichWayItWasPressed();
    void everySideOfAFoldHasItsHinges();
    void withoutFoldsNothingIsBuilt();
    void aWeightlessStripRestsAtItsAngle_data();
    void aWeightlessStripRestsAtItsAngle();
    void pressedFlatItLiesOnItselfWithoutPassingThrough();
    void theFoldBearsTheFlap();
    void anImageFoldsTheSameSideOfItsCloth();
    void theReportTellsOfFolds();
};

void tst_PressedFolds::aHingeKnowsWhichWayItWasPressed() {
    constexpr double pi = std::numbers::pi;
    for (const double rest : {0.3, 1.5, 2.5, pi})
        for (const double sign : {1.0, -1.0})
            for (double angle = -pi + 0.01; angle < pi; angle += 0.01) {
                const double from = cloth::angleFrom(sign * rest, angle);
                QVERIFY(std::abs(std::remainder(sign * rest + from - angle, 2 * pi)) < 1e-12);
                if (std::abs(angle) < pi / 2)
                    QVERIFY(from * sign < pi / 2 && std::abs(sign * rest + from - angle) < 1e-12);
            }
}

void tst_PressedFolds::everySideOfAFoldHasItsHinges() {
    for (const double askew : {0.0, 0.1}) {
        const Scene scene = strip(1, 3, askew);
        const Simulation simulation = simulationOf(scene);
        const Garment& garment = simulation.garment();
        const meshing::PieceMesh& mesh = garment.mesh->pieces[0];
        QCOMPARE(mesh.folds.size(), std::size_t(1));
        QCOMPARE(garment.folds.size(), std::size_t(1));
        const std::size_t sides = mesh.folds[0].size() - 1, hinges = garment.model.hinges.size();
        QCOMPARE(hinges, askew == 0 ? 2 * sides : sides); // between two rectangles one at each end
        for (const cloth::Hinge& hinge : garment.model.hinges) QCOMPARE(hinge.restAngle, 1.0);
        // Nothing else bends across: no stencil has nodes on both sides of the fold.
        const Vec2 from = mesh.material[mesh.folds[0].front()], to = mesh.material[mesh.folds[0].back()];
        for (const cloth::Stencil& stencil : garment.model.bending) {
            double least = 0, most = 0;
            for (const int p : stencil.particles) {
                if (p < 0) continue;
                const double side = cross(to - from, mesh.material[p] - from); // one piece: particles are nodes
                least = std::min(least, side);
                most = std::max(most, side);
            }
            QVERIFY(least > -1e-9 || most < 1e-9);
        }
    }
}

void tst_PressedFolds::withoutFoldsNothingIsBuilt() {
    Scene scene = strip(1);
    const auto isLeftOut = [](const Scene& of) {
        const Simulation simulation = simulationOf(of);
        return std::ranges::any_of(simulation.plan().leftOut(),
                                   [](const LeftOut& left) { return left.stage == "folds"; });
    };
    QVERIFY(!isLeftOut(scene));
    pattern::Piece flat = *scene.pattern.pieces[0];
    flat.folds.clear();
    scene.pattern.pieces[0] = flat;
    QVERIFY(isLeftOut(scene));
    const Simulation simulation = simulationOf(scene);
    QVERIFY(simulation.garment().folds.empty() && simulation.garment().model.hinges.empty());
    QVERIFY(simulation.garment().mesh->pieces[0].folds.empty());
}

void tst_PressedFolds::aWeightlessStripRestsAtItsAngle_data() {
    QTest::addColumn<double>("angle");
    QTest::addColumn<double>("askew");
    for (const double angle : {30.0, 90.0, -90.0, 150.0, 180.0, -180.0}) QTest::addRow("%g°", angle) << angle << 0.0;
    QTest::newRow("90° askew") << 90.0 << 0.1;
    QTest::newRow("−120° askew") << -120.0 << -0.1;
}
void tst_PressedFolds::aWeightlessStripRestsAtItsAngle() {
    QFETCH(double, angle);
    QFETCH(double, askew);
    Simulation simulation = simulationOf(strip(angle * degree, 1, askew));
    const auto report = sew(simulation, {});
    QVERIFY2(report.has_value(), report ? "" : toString(report.error()).c_str());
    QVERIFY(report->atRest);
    const FoldReport& fold = report->folds.front();
    qInfo("lies at %.3f°, from %.3f° to %.3f°", fold.mean / degree, fold.least / degree, fold.most / degree);
    // Nothing else acts on it: what is left is the residual that statics may leave, 1e-3 of a particle's weight.
    QVERIFY(std::abs(fold.mean - angle * degree) < 0.1 * degree);
    QVERIFY(fold.most - fold.least < 0.1 * degree);
}

void tst_PressedFolds::pressedFlatItLiesOnItselfWithoutPassingThrough() {
    for (const double angle : {180.0, -180.0}) {
        Scene scene = strip(angle * degree, 5);
        scene.settings.selfContact = true;
        Simulation simulation = simulationOf(scene);
        const auto report = sew(simulation, {});
        QVERIFY2(report.has_value(), report ? "" : toString(report.error()).c_str());
        const FoldReport& fold = report->folds.front();
        qInfo("lies at %.2f°, from %.2f° to %.2f°", fold.mean / degree, fold.least / degree, fold.most / degree);
        QVERIFY(std::abs(fold.mean) > 177 * degree); // one cell from the fold the layers are half a millimetre apart
        QVERIFY(std::signbit(fold.mean) == std::signbit(angle));
        QCOMPARE(report->contact.selfIntersections, 0);
    }
}

/// The moment of the hinges is that of the flap's weight about the fold.
void tst_PressedFolds::theFoldBearsTheFlap() {
    Scene scene = strip(90 * degree, 20);
    scene.settings.gravity = {0, -9.81, 0};
    scene.settings.damping = 5;
    pattern::Piece hanging = *scene.pattern.pieces[0];
    hanging.placement = pattern::Placement{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {}};
    scene.pattern.pieces[0] = hanging;
    for (const char* vertex : {"v0", "v3"})
        scene.pattern.pins.push_back({pattern::PinId(vertex), pattern::PieceId("strip"), pattern::VertexId(vertex)});
    Simulation simulation = simulationOf(scene);
    const auto report = sew(simulation, {});
    QVERIFY2(report.has_value() && report->atRest, "at rest");
    const Garment& garment = simulation.garment();
    const meshing::PieceMesh& mesh = garment.mesh->pieces[0];
    const auto& x = simulation.state().positions;
    const Vec3 a = x[mesh.folds[0].front()], b = x[mesh.folds[0].back()], along = (b - a) / distance(a, b);
    double hinges = 0, weight = 0;
    for (const cloth::Hinge& h : garment.model.hinges)
        hinges += h.stiffness * cloth::angleFrom(h.restAngle, cloth::foldAngle(x[h.a], x[h.b], x[h.c], x[h.d]).angle);
    for (std::size_t p = 0; p < x.size(); ++p)
        if (mesh.material[p].x > 0.5 * creasedLength + 1e-9)
            weight += dot(along, cross(x[p] - a, Vec3{0, -9.81, 0} * garment.model.mass[p]));
    qInfo("hinges %.4g N·m, weight %.4g N·m", hinges, weight);
    // The fold is not quite straight between its ends: half a percent.
    QVERIFY(std::abs(weight) > 1e-5);
    QVERIFY(std::abs(std::abs(hinges) - std::abs(weight)) < 0.005 * std::abs(weight));
}

void tst_PressedFolds::anImageFoldsTheSameSideOfItsCloth() {
    Scene scene = strip(90 * degree);
    pattern::Piece image;
    image.id = pattern::PieceId("image");
    image.name = "image";
    image.fabric = scene.pattern.pieces[0]->fabric;
    image.mirror = pattern::MirrorOf{pattern::PieceId("strip"), {0, 0}, {0, 1}};
    image.placement = scene.pattern.pieces[0]->placement;
    image.placement->transform.origin = {-0.1, 1, 0};
    scene.pattern.pieces.push_back(image);
    Simulation simulation = simulationOf(scene);
    const auto report = sew(simulation, {});
    QVERIFY(report.has_value());
    QCOMPARE(report->folds.size(), std::size_t(2));
    for (const FoldReport& fold : report->folds) QVERIFY(std::abs(fold.mean - 90 * degree) < 1 * degree);
}

void tst_PressedFolds::theReportTellsOfFolds() {
    Simulation simulation = simulationOf(strip(-90 * degree));
    const auto report = sew(simulation, {.seconds = 0.1});
    QVERIFY(report.has_value());
    const Json json = toJson(*report);
    const Json& fold = (*json.find("folds")->asArray())[0];
    QCOMPARE(*fold.find("piece")->asString(), std::string("strip"));
    QCOMPARE(*fold.find("name")->asString(), std::string("crease"));
    QVERIFY(std::abs(*fold.find("foldAngleDegrees")->asNumber() + 90) < 1e-9);
    QVERIFY(*fold.find("leastAngleDegrees")->asNumber() <= *fold.find("meanAngleDegrees")->asNumber());
}

TOILE_TEST(tst_PressedFolds)
#include "tst_PressedFolds.moc"
