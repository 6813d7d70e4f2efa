// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/Suite.h"
#include "tests/meshing/MeshReferee.h"

#include <QTest>
#include <map>

using namespace toile;
using namespace toile::meshing;

/// Regions: snapping, balance, slaves and the joints between them.
class tst_Regions : public QObject {
    Q_OBJECT
private slots:
    void aFineSquareInACoarseOneHasSlavesOnItsBorder();
    void aRegionEqualToThePieceIsAUniformFineMesh();
    void snappingReportsHowFarTheBorderMoved();
    void aBorderMovedTooFarIsWarnedOf();
    void anExactBorderStaysWhereItWasPainted();
    void anExactBorderMovesItsSlantedSidesAlone();
    void everyRatioUpToSixtyFourIsRingedDown_data();
    void everyRatioUpToSixtyFourIsRingedDown();
    void whereRegionsOverlapTheFinerCounts();
    void regionsThatShareACornerOnly();
    void aRegionWithAHole();
    void regionsAcrossTheBorderRefineItsNodes();
    void aRegionOutsideIsRefusedByName();
    void aRegionThatLosesItsCellsIsRefusedByName();
    void theMirroredTwinSnapsAlike();
};

namespace {

RegionInput region(std::string label, Polygon outline, int refinement) {
    return {std::move(label), std::move(outline), {}, refinement};
}

PieceInput squareWith(std::vector<RegionInput> regions) {
    PieceInput piece = rectanglePiece(1, 1, 1.0 / 16, "Square");
    piece.regions = std::move(regions);
    return piece;
}

/// Largest ratio of the sizes of two rectangles that share a corner node.
double largestSizeRatio(const PieceMesh& mesh) {
    std::vector<double> smallest(mesh.nodes.size(), 1e9), largest(mesh.nodes.size(), 0);
    for (const Rectangle& r : mesh.rectangles) {
        const double width = mesh.material[static_cast<std::size_t>(r.nodes[1])].x -
                             mesh.material[static_cast<std::size_t>(r.nodes[0])].x;
        for (const int node : r.nodes) {
            smallest[static_cast<std::size_t>(node)] = std::min(smallest[static_cast<std::size_t>(node)], width);
            largest[static_cast<std::size_t>(node)] = std::max(largest[static_cast<std::size_t>(node)], width);
        }
    }
    double worst = 0;
    for (std::size_t i = 0; i < smallest.size(); ++i) worst = std::max(worst, largest[i] / smallest[i]);
    return worst;
}

#define VERIFY_SOUND(garment)                                                                                          \
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());                                               \
    QCOMPARE(                                                                                                          \
        QString::fromStdString(defectOf(garment->pieces[0], static_cast<int>(garment->pieces[0].loops.size()) - 1)),   \
        QString())

} // namespace

void tst_Regions::aFineSquareInACoarseOneHasSlavesOnItsBorder() {
    const auto garment = meshGarment(inputOf(squareWith({region("middle", box(0.25, 0.25, 0.75, 0.75), 1)})));
    VERIFY_SOUND(garment);
    const PieceMesh& mesh = garment->pieces[0];
    QCOMPARE(mesh.rectangles.size(), std::size_t{16 * 16 - 8 * 8 + 16 * 16});
    QCOMPARE(mesh.nodes.size(), std::size_t{17 * 17 - 9 * 9 + 17 * 17});
    QCOMPARE(mesh.slaves.size(), std::size_t{4 * 8});
    for (const SlaveNode& slave : mesh.slaves) {
        QCOMPARE(slave.masters.size(), std::size_t{2});
        QCOMPARE(slave.masters[0].second, 0.5);
        QVERIFY(slave.node >= static_cast<int>(mesh.nodes.size() - mesh.slaves.size())); // slaves come last
    }
    QCOMPARE(largestSizeRatio(mesh), 2.0);
    QCOMPARE(garment->report.pieces[0].regions[0].cells, 64);
    QVERIFY(garment->report.pieces[0].regions[0].displacement < 1e-12);
    QVERIFY(garment->report.pieces[0].minimumAngle > 26.5 / 57.2957795); // 2:1 templates: atan(1/2)
}

void tst_Regions::aRegionEqualToThePieceIsAUniformFineMesh() {
    const auto garment = meshGarment(inputOf(squareWith({region("all", box(0, 0, 1, 1), 1)})));
    VERIFY_SOUND(garment);
    QCOMPARE(garment->pieces[0].nodes.size(), std::size_t{33 * 33});
    QVERIFY(garment->pieces[0].slaves.empty() && garment->pieces[0].triangles.empty());
}

void tst_Regions::snappingReportsHowFarTheBorderMoved() {
    const double cell = 1.0 / 16, off = 0.3 * cell;
    const auto garment = meshGarment(inputOf(squareWith({region("moved", box(0.25 + off, 0.25, 0.75, 0.75), 1)})));
    VERIFY_SOUND(garment);
    const RegionReport& report = garment->report.pieces[0].regions[0];
    QVERIFY(std::abs(report.displacement - off) < 1e-9);
    QVERIFY(std::abs(report.areaChange - off * 0.5) < 1e-9);
    QVERIFY(garment->report.warnings.empty()); // 0.3 of a cell is within the promise of half a cell
}

void tst_Regions::aBorderMovedTooFarIsWarnedOf() {
    // A corner in the middle of a cell moves by half the cell's diagonal: 0.71 of it.
    const double cell = 1.0 / 16;
    const auto garment =
        meshGarment(inputOf(squareWith({region("moved", box(4.5 * cell, 4.5 * cell, 12 * cell, 12 * cell), 1)})));
    VERIFY_SOUND(garment);
    QVERIFY(std::abs(garment->report.pieces[0].regions[0].displacement - std::sqrt(0.5) * cell) < 1e-9);
    QCOMPARE(garment->report.warnings.size(), std::size_t{1});
    QVERIFY(garment->report.warnings[0].text.find("\"moved\" moved by 44.2 mm") != std::string::npos);
}

void tst_Regions::anExactBorderStaysWhereItWasPainted() {
    PieceInput piece = squareWith({region("exact", box(0.262, 0.251, 0.731, 0.777), 1)});
    piece.border = RegionBorder::exact;
    const auto garment = meshGarment(inputOf(piece));
    VERIFY_SOUND(garment);
    QVERIFY(garment->report.pieces[0].regions[0].displacement < 1e-12);
    QVERIFY(std::abs(garment->report.pieces[0].regions[0].areaChange) < 1e-12);
    QVERIFY(garment->pieces[0].rectangles.size() > 400);
}

void tst_Regions::anExactBorderMovesItsSlantedSidesAlone() {
    // A box with one corner cut off: lines go through its four grain-parallel sides, the slanted one becomes stairs.
    PieceInput piece =
        squareWith({region("cut", {{0.262, 0.251}, {0.731, 0.251}, {0.731, 0.61}, {0.6, 0.777}, {0.262, 0.777}}, 1)});
    piece.border = RegionBorder::exact;
    const auto garment = meshGarment(inputOf(piece));
    VERIFY_SOUND(garment);
    const RegionReport& report = garment->report.pieces[0].regions[0];
    QVERIFY(report.displacement > 1e-3 && report.displacement < 1.0 / 16);
    const PieceMesh& mesh = garment->pieces[0];
    geometry::Box2 fine{{1, 1}, {0, 0}};
    for (const Rectangle& r : mesh.rectangles) {
        if (r.region != 0) continue;
        const Vec2 low = mesh.material[static_cast<std::size_t>(r.nodes[0])],
                   high = mesh.material[static_cast<std::size_t>(r.nodes[2])];
        fine.low = {std::min(fine.low.x, low.x), std::min(fine.low.y, low.y)};
        fine.high = {std::max(fine.high.x, high.x), std::max(fine.high.y, high.y)};
    }
    const double unit = 1e-6; // lines lie on the integer grid
    QVERIFY(distance(fine.low, Vec2{0.262, 0.251}) < unit && distance(fine.high, Vec2{0.731, 0.777}) < unit);
}

void tst_Regions::everyRatioUpToSixtyFourIsRingedDown_data() {
    QTest::addColumn<int>("refinement");
    for (int m = 1; m <= 6; ++m) QTest::addRow("1 : %d", 1 << m) << m;
}

void tst_Regions::everyRatioUpToSixtyFourIsRingedDown() {
    QFETCH(int, refinement);
    const double cell = 1.0 / 16;
    const auto garment =
        meshGarment(inputOf(squareWith({region("spot", box(8 * cell, 8 * cell, 9 * cell, 9 * cell), refinement)})));
    VERIFY_SOUND(garment);
    const PieceMesh& mesh = garment->pieces[0];
    QCOMPARE(largestSizeRatio(mesh), 2.0);
    std::map<double, int> cellsOfWidth; // in the spot and in the rings round it
    for (const Rectangle& r : mesh.rectangles)
        ++cellsOfWidth[std::round(cell / (mesh.material[static_cast<std::size_t>(r.nodes[1])].x -
                                          mesh.material[static_cast<std::size_t>(r.nodes[0])].x))];
    QCOMPARE(cellsOfWidth.size(), static_cast<std::size_t>(refinement + 1)); // 1, 2, 4 … 2^m parts of a cell
    QCOMPARE(cellsOfWidth.rbegin()->first, std::ldexp(1, refinement));
    QCOMPARE(cellsOfWidth.rbegin()->second, 1 << (2 * refinement)); // the whole spot, nothing beside it
    QVERIFY(mesh.triangles.size() < 1400); // the border strip where the rings reach it, nothing else
}

void tst_Regions::whereRegionsOverlapTheFinerCounts() {
    const auto garment = meshGarment(inputOf(
        squareWith({region("coarse", box(0.25, 0.25, 0.75, 0.75), 1), region("fine", box(0.5, 0.25, 0.75, 0.75), 2)})));
    VERIFY_SOUND(garment);
    QCOMPARE(garment->report.pieces[0].regions[0].cells, 32);
    QCOMPARE(garment->report.pieces[0].regions[1].cells, 32);
    QCOMPARE(garment->report.warnings.size(), std::size_t{1});
    QVERIFY(garment->report.warnings[0].text.find("\"fine\"") != std::string::npos);
}

void tst_Regions::regionsThatShareACornerOnly() {
    const auto garment = meshGarment(
        inputOf(squareWith({region("a", box(0.25, 0.25, 0.5, 0.5), 1), region("b", box(0.5, 0.5, 0.75, 0.75), 1)})));
    VERIFY_SOUND(garment);
    QCOMPARE(garment->pieces[0].slaves.size(), std::size_t{2 * 16});
}

void tst_Regions::aRegionWithAHole() {
    RegionInput ring = region("ring", box(0.25, 0.25, 0.75, 0.75), 1);
    ring.holes.push_back(box(0.375, 0.375, 0.625, 0.625));
    const auto garment = meshGarment(inputOf(squareWith({ring})));
    VERIFY_SOUND(garment);
    QCOMPARE(garment->report.pieces[0].regions[0].cells, 64 - 16);
    QCOMPARE(garment->pieces[0].slaves.size(), std::size_t{4 * 8 + 4 * 4});
}

void tst_Regions::regionsAcrossTheBorderRefineItsNodes() {
    PieceInput piece = bodicePiece(0.02);
    piece.regions = {region("shoulder", box(0.05, 0.45, 0.3, 0.7), 1), region("hip", box(-0.1, -0.1, 0.3, 0.11), 2)};
    const auto garment = meshGarment(inputOf(piece));
    VERIFY_SOUND(garment);
    const auto parts = [&](std::size_t edge) { return garment->pieces[0].loops[0][edge].size() - 1; };
    QCOMPARE(parts(3),
             static_cast<std::size_t>(std::ceil(geometry::length(piece.outline[3].curve) / 0.01))); // shoulder
    QCOMPARE(parts(0),
             static_cast<std::size_t>(std::ceil(geometry::length(piece.outline[0].curve) / 0.005))); // hem
    QVERIFY(largestSizeRatio(garment->pieces[0]) <= 2.0 + 1e-9);
}

void tst_Regions::aRegionOutsideIsRefusedByName() {
    for (const Polygon& outline : {box(2, 2, 3, 3), box(1, 0, 2, 1)}) { // away, and touching along a side
        const auto refused = meshGarment(inputOf(squareWith({region("lost", outline, 1)})));
        QVERIFY(!refused);
        QCOMPARE(refused.error().place.object, std::string("piece \"Square\", region \"lost\""));
        QVERIFY(refused.error().text.find("outside") != std::string::npos);
    }
}

void tst_Regions::aRegionThatLosesItsCellsIsRefusedByName() {
    const auto refused = meshGarment(inputOf(squareWith({region("speck", box(0.51, 0.51, 0.52, 0.52), 1)})));
    QVERIFY(!refused);
    QCOMPARE(refused.error().place.object, std::string("piece \"Square\", region \"speck\""));
}

void tst_Regions::theMirroredTwinSnapsAlike() {
    PieceInput piece = bodicePiece(0.02);
    piece.regions = {region("slanted", {{0.03, 0.11}, {0.2, 0.18}, {0.17, 0.33}, {0.06, 0.29}}, 1)};
    PieceInput twin = piece;
    twin.mirrored = true;
    const Vec2 a{0.4, 0}, b{0.4, 1};
    std::reverse(twin.outline.begin(), twin.outline.end());
    for (BoundaryEdge& edge : twin.outline) edge.curve = geometry::reversed(geometry::mirrored(edge.curve, a, b));
    std::reverse(twin.regions[0].outline.begin(), twin.regions[0].outline.end());
    for (Vec2& corner : twin.regions[0].outline) corner = geometry::mirrored(corner, a, b);
    const auto garment = meshGarment({{piece, twin}, {}});
    VERIFY_SOUND(garment);
    QCOMPARE(garment->pieces[0].nodes.size(), garment->pieces[1].nodes.size());
    for (std::size_t i = 0; i < garment->pieces[0].nodes.size(); ++i)
        QVERIFY(distance(geometry::mirrored(garment->pieces[0].nodes[i], a, b), garment->pieces[1].nodes[i]) < 1e-14);
    QVERIFY(!garment->pieces[0].slaves.empty());
}

TOILE_TEST(tst_Regions)
#include "tst_Regions.moc"
