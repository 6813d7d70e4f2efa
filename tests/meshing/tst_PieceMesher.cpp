// SPDX-License-Identifier: GPL-3.0-or-later
#include <QTest>

#ifndef Q_MOC_RUN // moc stumbles over the library's concepts
#include "core/base/heap/HeapCount.h"
#include "core/meshing/GarmentMesher.h"
#include "tests/Suite.h"
#include "tests/meshing/MeshFixtures.h"
#include "tests/meshing/PreparedPiece.h"

#include <algorithm>
#include <array>
#include <random>
#endif

using namespace toile;
using namespace toile::meshing;

class tst_PieceMesher : public QObject {
    Q_OBJECT
private slots:
    void meshingAgainAllocatesNothing_data();
    void meshingAgainAllocatesNothing();
    void meshingAGarmentAgainAllocatesNothing_data();
    void meshingAGarmentAgainAllocatesNothing();
    void whatWasMeshedBeforeDoesNotMatter();
    void mendingTheStripIsTriangulatingItAnew();
    void aSymmetricPieceGetsASymmetricMesh();
};

namespace {

/// A star of n straight edges, which wants many passes of improvement.
PieceInput starPiece(unsigned seed, double spacing) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(0.12, 0.3);
    const int n = 5 + static_cast<int>(random() % 20);
    std::vector<Vec2> corners;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * M_PI * i / n, r = radius(random);
        corners.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return polygonPiece(corners, spacing);
}

PieceInput withRegion(PieceInput piece) {
    piece.regions = {{"middle", {{0.05, 0.1}, {0.2, 0.1}, {0.2, 0.3}, {0.05, 0.3}}, {}, 2}};
    return piece;
}

std::vector<std::array<GridPoint, 3>> trianglesOf(const Strip& strip) {
    std::vector<std::array<GridPoint, 3>> triangles;
    for (int t = 0; t < strip.sides.triangles(); ++t) {
        std::array<GridPoint, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = strip.points[static_cast<std::size_t>(strip.sides.corners(t)[i])];
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        triangles.push_back(corners);
    }
    std::sort(triangles.begin(), triangles.end());
    return triangles;
}

/// The improved strip of a piece and how many cells it leaves.
std::pair<std::vector<std::array<GridPoint, 3>>, std::ptrdiff_t> improvedStrip(const PreparedPiece& piece,
                                                                               const ImprovementSettings& settings) {
    const PieceFrame& frame = piece.boundary.frame;
    Lattice lattice = piece.lattice;
    GridFill fill;
    fill.lines.assign(frame, lattice);
    BorderSegments segments;
    segments.assign(piece.border.nodes, fill.lines);
    markActiveCells(fill.lines, segments, lattice);
    seedFromBorder(piece.border.seeds, lattice);
    std::vector<std::pair<int, int>> open;
    balance(lattice, open);
    lattice.number();
    GridFiller().run(frame, piece.border.nodes, segments, lattice, clearance, fill);
    std::vector<Vec2> borderPlaces;
    const NodePlaces places(frame, piece.border.nodes, lattice, fill, borderPlaces);
    CellLayer layer;
    Strip strip;
    StripImprover().run(frame, piece.border.nodes, lattice, places, fill, layer, strip, settings);
    return {trianglesOf(strip), std::count(fill.filled.begin(), fill.filled.end(), char{1})};
}

} // namespace

void tst_PieceMesher::meshingAgainAllocatesNothing_data() {
    QTest::addColumn<PieceInput>("piece");
    QTest::newRow("bodice") << bodicePiece(0.005);
    QTest::newRow("bodice, fine") << bodicePiece(0.002);
    QTest::newRow("bodice with a region four times as fine") << withRegion(bodicePiece(0.01));
    QTest::newRow("star that wants improvement") << starPiece(1, 0.01);
    QTest::newRow("circle") << circlePiece(0.2, 0.005);
}

void tst_PieceMesher::meshingAgainAllocatesNothing() {
    QFETCH(PieceInput, piece);
    const PreparedPiece ready = prepared(piece);
    PieceMesher mesher;
    PieceMesh mesh;
    for (int time = 0; time < 2; ++time)
        QVERIFY(mesher.run(ready.input, ready.boundary, ready.border.nodes, ready.border.seeds, ready.lattice, mesh));
    const PieceMesh before = mesh;
    const HeapCount first = heapTaken();
    const auto done =
        mesher.run(ready.input, ready.boundary, ready.border.nodes, ready.border.seeds, ready.lattice, mesh);
    const std::size_t taken = (heapTaken() - first).blocks;
    QVERIFY(done);
    QCOMPARE(taken, std::size_t(0));
    QVERIFY(mesh == before);
}

void tst_PieceMesher::meshingAGarmentAgainAllocatesNothing_data() {
    QTest::addColumn<MeshInput>("input");
    const auto sewn = [](double spacing) {
        return MeshInput{{bodicePiece(spacing), bodicePiece(spacing)}, {{"side", {{{{0, 0, 1}}, {{1, 0, 1}}}}, {}}}};
    };
    QTest::newRow("two bodices sewn at the side") << sewn(0.02);
    QTest::newRow("the same, fine") << sewn(0.005);
    MeshInput painted = sewn(0.01);
    painted.pieces[0] = withRegion(painted.pieces[0]);
    QTest::newRow("with a region four times as fine") << painted;
    MeshInput literal = sewn(0.01);
    for (PieceInput& piece : literal.pieces) piece.rule = LineRule::paper;
    QTest::newRow("by the paper's rule") << literal;
    QTest::newRow("a star with many edges") << MeshInput{{starPiece(7, 0.01)}, {}};
}

/// From the gate to the sewn nodes.
void tst_PieceMesher::meshingAGarmentAgainAllocatesNothing() {
    QFETCH(MeshInput, input);
    GarmentMesher mesher({.judged = false});
    std::array<std::size_t, 8> taken{};
    for (std::size_t& ofTime : taken) {
        mesher.forget();
        const HeapCount first = heapTaken();
        const auto mesh = mesher.mesh(input);
        ofTime = (heapTaken() - first).blocks;
        QVERIFY(mesh);
    }
    QVERIFY(taken.front() > 0);
    QCOMPARE(*std::min_element(taken.begin(), taken.end()),
             std::size_t(0)); // which thread meshes which piece is chance
}

void tst_PieceMesher::whatWasMeshedBeforeDoesNotMatter() {
    PieceMesher kept;
    for (unsigned seed = 1; seed <= 30; ++seed) {
        const PreparedPiece ready = prepared(seed % 3 == 0 ? withRegion(bodicePiece(0.004 + 0.001 * seed))
                                                           : starPiece(seed, 0.004 + 0.0007 * seed));
        PieceMesh mesh, fresh;
        QVERIFY(kept.run(ready.input, ready.boundary, ready.border.nodes, ready.border.seeds, ready.lattice, mesh));
        QVERIFY(PieceMesher().run(ready.input, ready.boundary, ready.border.nodes, ready.border.seeds, ready.lattice,
                                  fresh));
        QVERIFY2(mesh == fresh, qPrintable(QString::number(seed)));
    }
}

void tst_PieceMesher::mendingTheStripIsTriangulatingItAnew() {
    int improved = 0;
    for (unsigned seed = 1; seed <= 200; ++seed) {
        const PreparedPiece ready = prepared(starPiece(seed, 0.006 + 0.0002 * (seed % 60)));
        const auto mended = improvedStrip(ready, {}), anew = improvedStrip(ready, {.anew = true});
        QVERIFY2(mended == anew, qPrintable(QString::number(seed)));
        improved += mended != improvedStrip(ready, {.passes = 0});
    }
    QVERIFY(improved > 50); // there was something to compare
}

void tst_PieceMesher::aSymmetricPieceGetsASymmetricMesh() {
    for (unsigned seed = 1; seed <= 40; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> width(0.1, 0.25);
        std::vector<Vec2> right, left;
        for (int i = 0; i < 5; ++i) right.push_back({width(random), 0.11 * i});
        for (const Vec2 corner : right) left.insert(left.begin(), {-corner.x, corner.y});
        std::vector<Vec2> corners = right;
        corners.insert(corners.end(), left.begin(), left.end());
        const PreparedPiece ready = prepared(polygonPiece(corners, 0.01 + 0.0003 * seed));
        PieceMesh mesh;
        QVERIFY(PieceMesher().run(ready.input, ready.boundary, ready.border.nodes, ready.border.seeds, ready.lattice,
                                  mesh));
        int unmatched = 0;
        for (const Vec2 node : mesh.nodes)
            unmatched += std::none_of(mesh.nodes.begin(), mesh.nodes.end(), [&](Vec2 other) {
                return distance(Vec2{-node.x, node.y}, other) < 1e-5; // the grid's rounding is not symmetric
            });
        QVERIFY2(unmatched == 0,
                 qPrintable(QString("seed %1: %2 of %3").arg(seed).arg(unmatched).arg(mesh.nodes.size())));
    }
}

TOILE_TEST(tst_PieceMesher)
#include "tst_PieceMesher.moc"
