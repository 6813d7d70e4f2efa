// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/geometry/Shapes.h"
#include "core/simulation/LayersApart.h"
#include "core/simulation/Sew.h"
#include "core/simulation/Topology.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"

#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double wide = 0.3, high = 0.15; ///< of a panel [m]

/// A panel that lies flat in front of the observer, its right side to the front.
Shared<pattern::Piece> flatPanel(const char* id, int layer, double z) {
    pattern::Piece piece = polygonPiece(id, {{0, 0}, {wide, 0}, {wide, high}, {0, high}}, 0.03);
    piece.layer = layer;
    piece.placement = pattern::Placement{};
    piece.placement->transform.origin = {-wide / 2, 1, z};
    return piece;
}

Scene twoPanels(int layerOfFirst, double zOfFirst, int layerOfSecond, double zOfSecond) {
    Scene scene;
    scene.pattern.fabrics.push_back(plainCloth());
    scene.pattern.pieces = {flatPanel("first", layerOfFirst, zOfFirst), flatPanel("second", layerOfSecond, zOfSecond)};
    return scene;
}

/// A strip that wraps an upright cylinder of 0.1 m once and is sewn to itself.
Shared<pattern::Piece> band(const char* id, int layer, double girth, double startRadius) {
    pattern::Piece piece =
        polygonPiece(id, {{-girth / 2, 0}, {girth / 2, 0}, {girth / 2, high}, {-girth / 2, high}}, 0.02);
    piece.layer = layer;
    piece.placement = pattern::Placement{};
    piece.placement->transform.origin = {0, -high / 2, startRadius};
    piece.placement->curl = pattern::Curl{{0, 1}, startRadius};
    return piece;
}

/// Two bands round that cylinder, one over the other, that start at these radii.
Scene twoBands(double startOfInner, double startOfOuter) {
    Scene scene;
    scene.settings.gravity = {};
    scene.settings.selfContact = true;
    scene.pattern.fabrics.push_back(plainCloth());
    constexpr double round = 2 * std::numbers::pi;
    scene.pattern.pieces = {band("inner", 0, round * 0.112, startOfInner),
                            band("outer", 1, round * 0.122, startOfOuter)};
    scene.pattern.seams = {seamBetween("inner", "inner", "e1", "inner", "e3"),
                           seamBetween("outer", "outer", "e1", "outer", "e3")};
    body::Body cylinder;
    cylinder.name = "cylinder";
    cylinder.mesh = geometry::cylinder(0.1, 0.3, 64, 12);
    scene.body = Shared<body::Body>(std::move(cylinder));
    return scene;
}

struct Radii {
    double least = 1e9, largest = 0;
};

Radii radiiOf(const Simulation& simulation, std::size_t piece) {
    Radii radii;
    const std::vector<Vec3> nodes = simulation.nodePositions();
    const Garment& garment = simulation.garment();
    for (std::size_t node = 0; node < garment.mesh->pieces[piece].nodes.size(); ++node) {
        const Vec3& p = nodes[garment.particles.firstNode[piece] + node];
        radii.least = std::min(radii.least, std::hypot(p.x, p.z));
        radii.largest = std::max(radii.largest, std::hypot(p.x, p.z));
    }
    return radii;
}

} // namespace

/// Which of two pieces lies outside.
class tst_LayersApart : public QObject {
    Q_OBJECT
private slots:
    void piecesOfOneLayerStayWhereTheyArePlaced();
    void aHigherLayerStartsOutside_data();
    void aHigherLayerStartsOutside();
    void whatLiesBesideStaysWhereItIs();
    void aBackIsNotOverAFront();
    void aCurledPieceIsWidenedAboutItsMiddle();
    void layersLieOneOverTheOther();
    void nodesInWrongOrderAreCounted();
    void besideASeamThereIsNoOrder();
    void bandsEndInTheirOrder_data();
    void bandsEndInTheirOrder();
};

void tst_LayersApart::piecesOfOneLayerStayWhereTheyArePlaced() {
    const Scene scene = twoPanels(1, 0.1, 1, 0.1);
    QVERIFY(layersApart(scene.pattern, meshOf(scene.pattern)) == scene.pattern);
}

void tst_LayersApart::aHigherLayerStartsOutside_data() {
    QTest::addColumn<double>("inner");
    QTest::addColumn<double>("outer");
    QTest::newRow("drawn in one plane") << 0.1 << 0.1;
    QTest::newRow("drawn in the wrong order") << 0.12 << 0.09;
    QTest::newRow("drawn too near") << 0.1 << 0.101;
    QTest::newRow("drawn as it should be") << 0.1 << 0.12;
}

void tst_LayersApart::aHigherLayerStartsOutside() {
    QFETCH(double, inner);
    QFETCH(double, outer);
    for (const bool outerIsFirst : {true, false}) {
        const Scene scene = outerIsFirst ? twoPanels(2, outer, 0, inner) : twoPanels(0, inner, 2, outer);
        const std::size_t high = outerIsFirst ? 0 : 1;
        const pattern::Pattern apart = layersApart(scene.pattern, meshOf(scene.pattern));
        QVERIFY(*apart.pieces[1 - high] == *scene.pattern.pieces[1 - high]);
        const double z = apart.pieces[high]->placement->transform.origin.z;
        QVERIFY(z >= inner + 0.005 - 1e-12 && z <= std::max(outer, inner + 0.0075 + 1e-12));
    }
}

void tst_LayersApart::whatLiesBesideStaysWhereItIs() {
    Scene scene = twoPanels(0, 0.1, 1, 0.1);
    pattern::Piece outer = *scene.pattern.pieces[1];
    outer.placement->transform.origin.x += wide + 0.01;
    scene.pattern.pieces[1] = outer;
    QVERIFY(layersApart(scene.pattern, meshOf(scene.pattern)) == scene.pattern);
}

void tst_LayersApart::aBackIsNotOverAFront() {
    Scene scene = twoPanels(0, 0.01, 1, 0);
    pattern::Piece back = *scene.pattern.pieces[1];
    back.placement->transform = {{-1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {wide / 2, 1, -0.01}};
    scene.pattern.pieces[1] = back;
    QVERIFY(layersApart(scene.pattern, meshOf(scene.pattern)) == scene.pattern);
}

void tst_LayersApart::aCurledPieceIsWidenedAboutItsMiddle() {
    const Scene scene = twoBands(0.13, 0.125);
    const pattern::Pattern apart = layersApart(scene.pattern, meshOf(scene.pattern));
    const pattern::Placement& outer = *apart.pieces[1]->placement;
    QVERIFY(outer.curl->radius >= 0.13 + 0.0045 && outer.curl->radius <= 0.13 + 0.008);
    QVERIFY(std::abs(outer.transform.origin.z - outer.curl->radius) < 1e-12);
}

void tst_LayersApart::layersLieOneOverTheOther() {
    Scene scene = twoPanels(0, 0.1, 1, 0.1);
    scene.pattern.pieces.push_back(flatPanel("third", 2, 0.1));
    const pattern::Pattern apart = layersApart(scene.pattern, meshOf(scene.pattern));
    const auto z = [&](std::size_t piece) { return apart.pieces[piece]->placement->transform.origin.z; };
    QVERIFY(z(1) - z(0) >= 0.005 - 1e-12 && z(2) - z(1) >= 0.005 - 1e-12);
}

void tst_LayersApart::nodesInWrongOrderAreCounted() {
    const Scene scene = twoPanels(0, 0.1, 1, 0.09);
    const meshing::GarmentMesh mesh = meshOf(scene.pattern);
    const int all = static_cast<int>(mesh.pieces[1].nodes.size());
    QCOMPARE(nodesInWrongOrder(scene.pattern, mesh, placedNodes(scene.pattern, mesh)), all);
    const pattern::Pattern apart = layersApart(scene.pattern, mesh);
    QCOMPARE(nodesInWrongOrder(apart, mesh, placedNodes(apart, mesh)), 0);
    const Scene alike = twoPanels(0, 0.1, 0, 0.09);
    QCOMPARE(nodesInWrongOrder(alike.pattern, mesh, placedNodes(alike.pattern, mesh)), 0);
}

void tst_LayersApart::besideASeamThereIsNoOrder() {
    const Scene scene = twoPanels(0, 0.1, 1, 0.09);
    const meshing::GarmentMesh mesh = meshOf(scene.pattern);
    std::vector<Vec3> nodes = placedNodes(scene.pattern, mesh);
    const std::span<Vec3> second = std::span(nodes).subspan(mesh.pieces[0].nodes.size());
    const Vec3 seam = second.front() = nodes.front();
    second[1] = seam + Vec3{0.01, 0.01, -0.01}; // behind the first panel
    const auto far = std::ranges::count_if(second, [&](const Vec3& p) { return geometry::distance(p, seam) >= 0.02; });
    QCOMPARE(far, std::ssize(second) - 2);
    QCOMPARE(nodesInWrongOrder(scene.pattern, mesh, nodes), static_cast<int>(far));
}

void tst_LayersApart::bandsEndInTheirOrder_data() {
    QTest::addColumn<double>("inner");
    QTest::addColumn<double>("outer");
    QTest::newRow("drawn in their order") << 0.125 << 0.14;
    QTest::newRow("drawn at one radius") << 0.13 << 0.13;
    QTest::newRow("drawn in the wrong order") << 0.14 << 0.125;
}

void tst_LayersApart::bandsEndInTheirOrder() {
    QFETCH(double, inner);
    QFETCH(double, outer);
    auto simulation = Simulation::create(twoBands(inner, outer));
    QVERIFY2(simulation, simulation ? "" : toString(simulation.error()).c_str());
    const auto report = sew(*simulation, {});
    QVERIFY2(report, report ? "" : toString(report.error()).c_str());
    QVERIFY(report->allClosed() && report->atRest && report->contact.outsideBody);
    QCOMPARE(report->contact.selfIntersections, 0);
    QCOMPARE(report->contact.nodesInWrongOrder, 0);
    QVERIFY(radiiOf(*simulation, 1).least > 0.1 && radiiOf(*simulation, 0).least > 0.1);
}

TOILE_TEST(tst_LayersApart)
#include "tst_LayersApart.moc"
