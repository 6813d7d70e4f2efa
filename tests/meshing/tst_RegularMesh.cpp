// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Streaming.h"
#include "tests/Suite.h"
#include "tests/meshing/MeshReferee.h"

#include <QTest>

using namespace toile;
using namespace toile::meshing;

/// Pieces of one region under the regular rule.
class tst_RegularMesh : public QObject {
    Q_OBJECT
private slots:
    void aSquareIsRectanglesOnly();
    void aSquareLargerThanTheCachesIsWrittenAlike();
    void neighboursOnTheGridAreNearInMemory();
    void aTurnedSquareIsRectanglesAlongItsGrain();
    void everyShapeGivesAValidMesh_data();
    void everyShapeGivesAValidMesh();
    void boundaryNodesLieOnTheirCurves();
    void theMirroredTwinIsTheMirrorImage();
    void aBandSewnToSeveralPiecesIsRectanglesOnly();
    void aBandTakesTheFinerNodesOfWhatIsGatheredIntoIt();
    void aFreeEdgeTakesTheFixedPointsOfTheEdgeItFaces();
    void fixedPointsTooNearForTwoLinesLeaveAStrip();
};

namespace {

PieceInput turnedSquare(double angle) {
    std::vector<Vec2> corners{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    for (Vec2& corner : corners) corner = geometry::rotated(corner, angle);
    PieceInput piece = polygonPiece(corners, 1.0 / 32);
    piece.grain = angle;
    return piece;
}

PieceInput ringPiece() {
    PieceInput piece = circlePiece(0.3, 0.02);
    piece.holes.push_back(circleLoop({0.02, 0.01}, 0.1, true));
    return piece;
}

} // namespace

void tst_RegularMesh::aSquareIsRectanglesOnly() {
    const auto garment = meshGarment(inputOf(rectanglePiece(1, 1, 1.0 / 32)));
    QVERIFY(garment);
    const PieceMesh& mesh = garment->pieces[0];
    QCOMPARE(mesh.nodes.size(), std::size_t{33 * 33});
    QCOMPARE(mesh.rectangles.size(), std::size_t{32 * 32});
    QVERIFY(mesh.triangles.empty());
    QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
}

void tst_RegularMesh::aSquareLargerThanTheCachesIsWrittenAlike() {
    for (const bool mirrored : {false, true}) {
        PieceInput piece = rectanglePiece(1, 1, 1.0 / 1024);
        piece.mirrored = mirrored;
        const auto garment = meshGarment(inputOf(piece), {.judged = false});
        QVERIFY(garment);
        const PieceMesh& mesh = garment->pieces[0];
        QVERIFY(garment->report.total.bytes >= streamedFrom);
        QCOMPARE(mesh.nodes.size(), std::size_t{1025 * 1025});
        QCOMPARE(mesh.rectangles.size(), std::size_t{1024 * 1024});
        QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
        int wrong = 0; // a rectangle's size, or what it is displayed as
        for (std::size_t r = 0; r < mesh.rectangles.size(); ++r) {
            const auto& [a, b, c, d] = mesh.rectangles[r].nodes;
            const Vec2 size = mesh.material[static_cast<std::size_t>(c)] - mesh.material[static_cast<std::size_t>(a)];
            wrong += std::abs(size.x - 1.0 / 1024) > 1e-9 || std::abs(size.y - 1.0 / 1024) > 1e-9;
            for (const auto& triangle : {mesh.display[2 * r], mesh.display[2 * r + 1]})
                for (const int node : triangle) wrong += node != a && node != b && node != c && node != d;
        }
        QCOMPARE(wrong, 0);
    }
}

void tst_RegularMesh::neighboursOnTheGridAreNearInMemory() {
    // Row by row half of all sides would join nodes 129 apart; along a Morton curve few are farther than a block of 8
    // × 8.
    const auto garment = meshGarment(inputOf(rectanglePiece(1, 1, 1.0 / 128)));
    QVERIFY(garment);
    int near = 0, all = 0;
    for (const Rectangle& r : garment->pieces[0].rectangles)
        for (std::size_t i = 0; i < 4; ++i, ++all) near += std::abs(r.nodes[i] - r.nodes[(i + 1) % 4]) < 64;
    qInfo("%.1f %% of the sides join nodes less than 64 apart", 100.0 * near / all);
    QVERIFY(near > 0.85 * all);
}

void tst_RegularMesh::aTurnedSquareIsRectanglesAlongItsGrain() {
    for (const double angle : {0.3, -1.1, 2.5}) {
        const auto garment = meshGarment(inputOf(turnedSquare(angle)));
        QVERIFY(garment);
        QCOMPARE(garment->pieces[0].nodes.size(), std::size_t{33 * 33});
        QVERIFY(garment->pieces[0].triangles.empty());
        QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0])), QString());
    }
}

void tst_RegularMesh::everyShapeGivesAValidMesh_data() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<int>("holes");
    QTest::addRow("a triangle") << 0 << 0;
    QTest::addRow("a circle") << 1 << 0;
    QTest::addRow("a ring") << 2 << 1;
    QTest::addRow("a bodice at 20 mm") << 3 << 0;
    QTest::addRow("a bodice at 5 mm") << 4 << 0;
    QTest::addRow("an L") << 5 << 0;
}

void tst_RegularMesh::everyShapeGivesAValidMesh() {
    QFETCH(int, shape);
    QFETCH(int, holes);
    const std::vector<PieceInput> shapes{
        polygonPiece({{0, 0}, {0.4, 0.05}, {0.15, 0.35}}, 0.02),
        circlePiece(0.25, 0.02),
        ringPiece(),
        bodicePiece(0.02),
        bodicePiece(0.005),
        polygonPiece({{0, 0}, {0.3, 0}, {0.3, 0.11}, {0.12, 0.11}, {0.12, 0.4}, {0, 0.4}}, 0.02)};
    const auto garment = meshGarment(inputOf(shapes[static_cast<std::size_t>(shape)]));
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    QCOMPARE(QString::fromStdString(defectOf(garment->pieces[0], holes)), QString());
    const PieceReport& report = garment->report.pieces[0];
    qInfo("nodes %d, rectangles %.1f %%, angles %.1f … %.1f degrees", report.nodes, report.rectangleFraction * 100,
          report.minimumAngle * 57.29578, report.maximumAngle * 57.29578);
}

void tst_RegularMesh::boundaryNodesLieOnTheirCurves() {
    const PieceInput piece = bodicePiece(0.02);
    const auto garment = meshGarment(inputOf(piece));
    QVERIFY(garment);
    const PieceMesh& mesh = garment->pieces[0];
    for (std::size_t e = 0; e < piece.outline.size(); ++e) {
        const geometry::ArcLength arc(piece.outline[e].curve);
        for (const EdgeNode& node : mesh.loops[0][e])
            QVERIFY(distance(mesh.nodes[static_cast<std::size_t>(node.node)], arc.pointAt(node.fraction)) <= 1e-15);
        QCOMPARE(mesh.loops[0][e].size() - 1, static_cast<std::size_t>(std::ceil(arc.total() / 0.02 - 1e-9)));
        QVERIFY(mesh.nodes[static_cast<std::size_t>(mesh.loops[0][e].front().node)] == piece.outline[e].curve.start);
        QVERIFY(mesh.nodes[static_cast<std::size_t>(mesh.loops[0][e].back().node)] == piece.outline[e].curve.end);
    }
}

void tst_RegularMesh::theMirroredTwinIsTheMirrorImage() {
    const PieceInput piece = bodicePiece(0.02);
    const Vec2 a{0.4, 0}, b{0.4, 1};
    PieceInput twin = piece;
    twin.mirrored = true;
    std::reverse(twin.outline.begin(), twin.outline.end());
    for (BoundaryEdge& edge : twin.outline) edge.curve = geometry::reversed(geometry::mirrored(edge.curve, a, b));
    const auto garment = meshGarment({{piece, twin}, {}});
    QVERIFY(garment);
    const PieceMesh &mesh = garment->pieces[0], &image = garment->pieces[1];
    QCOMPARE(QString::fromStdString(defectOf(image)), QString());
    QCOMPARE(image.nodes.size(), mesh.nodes.size());
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) // the same order; rounding of two ways to one place
        QVERIFY(distance(geometry::mirrored(mesh.nodes[i], a, b), image.nodes[i]) < 1e-14);
    QCOMPARE(image.rectangles.size(), mesh.rectangles.size());
    QCOMPARE(image.triangles.size(), mesh.triangles.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        auto mine = mesh.triangles[i].nodes, its = image.triangles[i].nodes;
        std::sort(mine.begin(), mine.end());
        std::sort(its.begin(), its.end());
        QVERIFY(mine == its);
    }
}

void tst_RegularMesh::aBandSewnToSeveralPiecesIsRectanglesOnly() {
    // 0.23 and 0.31 m at 20 mm: 12 and 16 columns of different widths; 0.03 m: two rows.
    MeshInput input{
        {rectanglePiece(0.23, 0.5, 0.02), rectanglePiece(0.31, 0.5, 0.02), rectanglePiece(0.54, 0.03, 0.02)}, {}};
    input.seams = {seamOf({{0, 0, 2, 0, 1, true}, {1, 0, 2, 0, 1, true}}, {{2, 0, 0}})};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    const PieceMesh& band = garment->pieces[2];
    QVERIFY(band.triangles.empty());
    QCOMPARE(band.rectangles.size(), std::size_t{2 * (12 + 16)});
    QCOMPARE(QString::fromStdString(defectOf(band)), QString());
    for (const EdgeNode& below : band.loops[0][0]) { // the free edge above has its nodes straight over the seam's
        const Vec2 node = band.nodes[static_cast<std::size_t>(below.node)];
        QVERIFY(std::any_of(band.loops[0][2].begin(), band.loops[0][2].end(), [&](const EdgeNode& above) {
            return distance(band.nodes[static_cast<std::size_t>(above.node)], node + Vec2{0, 0.03}) < 1e-12;
        }));
    }
}

void tst_RegularMesh::aBandTakesTheFinerNodesOfWhatIsGatheredIntoIt() {
    MeshInput input{{rectanglePiece(0.8, 0.5, 0.02), rectanglePiece(0.4, 0.04, 0.02)}, {}};
    input.seams = {seamOf({{0, 0, 2, 0, 1, true}}, {{1, 0, 0}}, {{0, 2.0}})};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    for (const PieceMesh& mesh : garment->pieces) QVERIFY(mesh.triangles.empty());
    QCOMPARE(garment->pieces[0].rectangles.size(), std::size_t{40 * 25});
    QCOMPARE(garment->pieces[1].rectangles.size(), std::size_t{40 * 2});
}

void tst_RegularMesh::aFreeEdgeTakesTheFixedPointsOfTheEdgeItFaces() {
    MeshInput input{{rectanglePiece(0.4, 0.3, 0.02), rectanglePiece(0.4, 0.3, 0.02)}, {}};
    input.pieces[0].outline[2].notches = {0.33};
    input.pieces[1].outline[0].notches = {0.67};
    input.seams = {seamOf({{0, 0, 2, 0, 1, true}}, {{1, 0, 0}})};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    for (const PieceMesh& mesh : garment->pieces) QVERIFY(mesh.triangles.empty());
    const EdgeNodes& hem = garment->pieces[0].loops[0][0]; // 0.268 m in 14 parts, the notch's place, 0.132 m in 7
    QCOMPARE(hem.size(), std::size_t{14 + 7 + 1});
    QVERIFY(std::abs(hem[14].fraction - 0.67) < 1e-12);
}

void tst_RegularMesh::fixedPointsTooNearForTwoLinesLeaveAStrip() {
    MeshInput input{{rectanglePiece(0.4, 0.3, 0.02), rectanglePiece(0.4, 0.3, 0.02)}, {}};
    input.pieces[0].outline[2].notches = {0.67, 0.68}; // 4 mm apart
    input.pieces[1].outline[0].notches = {0.32, 0.33};
    input.seams = {seamOf({{0, 0, 2, 0, 1, true}}, {{1, 0, 0}})};
    const auto garment = meshGarment(input);
    QVERIFY2(garment, garment ? "" : toString(garment.error()).c_str());
    for (const PieceMesh& mesh : garment->pieces) {
        QCOMPARE(QString::fromStdString(defectOf(mesh)), QString());
        for (const Rectangle& r : mesh.rectangles)
            QVERIFY(mesh.material[static_cast<std::size_t>(r.nodes[1])].x -
                        mesh.material[static_cast<std::size_t>(r.nodes[0])].x >=
                    0.0099);
    }
    QVERIFY(garment->report.total.rectangleFraction > 0.85);
}

TOILE_TEST(tst_RegularMesh)
#include "tst_RegularMesh.moc"
