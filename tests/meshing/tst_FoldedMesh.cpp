// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/GarmentMesher.h"
#include "tests/Suite.h"
#include "tests/meshing/MeshReferee.h"

#include <QTest>

using namespace toile;
using namespace toile::meshing;

namespace {

/// From a place on an edge of the outline to one on another, with points between.
FoldInput foldAcross(const PieceInput& piece, FoldEndInput from, FoldEndInput to, std::vector<Vec2> between = {}) {
    const auto pointAt = [&](const FoldEndInput& end) {
        return geometry::ArcLength(piece.outline[static_cast<std::size_t>(end.edge)].curve).pointAt(end.fraction);
    };
    FoldInput fold{"fold", {pointAt(from)}, {from, to}};
    fold.points.insert(fold.points.end(), between.begin(), between.end());
    fold.points.push_back(pointAt(to));
    return fold;
}

} // namespace

class tst_FoldedMesh : public QObject {
    Q_OBJECT

private slots:
    void aFoldIsALineOfTheMesh_data() {
        QTest::addColumn<PieceInput>("piece");
        const auto row = [](const char* name, PieceInput piece, std::vector<FoldInput> folds) {
            piece.folds = std::move(folds);
            QTest::newRow(name) << piece;
        };
        const PieceInput strip = rectanglePiece(0.4, 0.1, 0.02), front = bodicePiece(0.02);
        row("along the grain", strip, {foldAcross(strip, {0, 0, 0.5}, {0, 2, 0.5})});
        row("along the grain, between lines", strip, {foldAcross(strip, {0, 0, 0.3333}, {0, 2, 1 - 0.3333})});
        row("askew", strip, {foldAcross(strip, {0, 0, 0.4}, {0, 2, 0.3})});
        row("bent", strip, {foldAcross(strip, {0, 0, 0.4}, {0, 2, 0.4}, {{0.2, 0.06}})});
        row("two folds", strip,
            {foldAcross(strip, {0, 0, 0.2}, {0, 2, 0.8}), foldAcross(strip, {0, 0, 0.5}, {0, 2, 0.4})});
        row("two folds nearer than the spacing", strip,
            {foldAcross(strip, {0, 0, 0.5}, {0, 2, 0.5}), foldAcross(strip, {0, 0, 0.52}, {0, 2, 0.48})});
        row("from corner to corner", strip, {foldAcross(strip, {0, 0, 0}, {0, 2, 0})});
        row("across a curved front", front, {foldAcross(front, {0, 5, 0.4}, {0, 1, 0.4})});
        row("round the neckline", front, {foldAcross(front, {0, 3, 0.7}, {0, 5, 0.1}, {{0.06, 0.5}, {0.03, 0.485}})});
        PieceInput fine = front;
        fine.spacing = 0.005;
        row("fine", fine, {foldAcross(fine, {0, 5, 0.4}, {0, 1, 0.4})});
        PieceInput turned = front;
        turned.grain = 0.4;
        row("askew to the grain", turned, {foldAcross(turned, {0, 5, 0.4}, {0, 1, 0.4})});
        PieceInput regions = front;
        regions.regions = {{"fine", {{0.05, 0.2}, {0.2, 0.2}, {0.2, 0.4}, {0.05, 0.4}}, {}, 2}};
        row("through a finer region", regions, {foldAcross(regions, {0, 5, 0.4}, {0, 1, 0.4})});
        PieceInput holed = front;
        holed.holes = {circleLoop({0.12, 0.3}, 0.03, true)};
        row("past a hole", holed, {foldAcross(holed, {0, 5, 0.7}, {0, 1, 0.3})});
        row("from a hole to the border", holed,
            {FoldInput{"fold", {{0.09, 0.3}, {0, 0.3}}, {{{1, 0, 0}, {0, 5, 0.23 / 0.53}}}}});
        PieceInput digitised = strip;
        std::vector<Vec2> corners;
        for (int i = 0; i < 400; ++i) {
            const double a = i * 0.015707963267948967;
            corners.push_back({0.15 * std::cos(a), 0.1 * std::sin(a)});
        }
        digitised.outline = loopThrough(corners);
        row("of a digitised outline", digitised, {foldAcross(digitised, {0, 103, 0.5}, {0, 297, 0})});
        for (const LineRule rule : {LineRule::features, LineRule::paper}) {
            PieceInput other = front;
            other.rule = rule;
            row(rule == LineRule::paper ? "by the paper's rule" : "through features", other,
                {foldAcross(other, {0, 5, 0.4}, {0, 1, 0.4})});
        }
    }
    void aFoldIsALineOfTheMesh() {
        QFETCH(PieceInput, piece);
        for (const bool mirrored : {false, true}) {
            piece.mirrored = mirrored;
            const auto mesh = meshGarment(inputOf(piece));
            QVERIFY2(mesh.has_value(), mesh ? "" : toString(mesh.error()).c_str());
            const PieceMesh& own = mesh->pieces[0];
            const std::string defect = defectOf(own, static_cast<int>(piece.holes.size()));
            QVERIFY2(defect.empty(), defect.c_str());
            QCOMPARE(own.folds.size(), piece.folds.size());
            for (const FoldReport& fold : mesh->report.pieces[0].folds) {
                const std::string wrong = foldDefectOf(own, fold, piece.spacing);
                QVERIFY2(wrong.empty(), wrong.c_str());
            }
            qInfo("%d nodes, %.1f %% rectangles, least angle %.1f°", mesh->report.total.nodes,
                  100 * mesh->report.total.rectangleFraction, mesh->report.total.minimumAngle * 57.29577951308232);
        }
    }

    void aFoldAlongTheGrainCostsNoRectangle() {
        PieceInput piece = rectanglePiece(0.4, 0.1, 0.02);
        piece.folds = {foldAcross(piece, {0, 0, 0.45}, {0, 2, 0.55})};
        const auto mesh = meshGarment(inputOf(piece));
        QVERIFY(mesh.has_value());
        QCOMPARE(mesh->pieces[0].triangles.size(), 0u);
        QCOMPARE(mesh->pieces[0].folds[0].size(), 6u);
    }

    void aPieceWithoutFoldsMeshesAsBefore() {
        PieceInput piece = bodicePiece(0.02);
        const auto plain = meshGarment(inputOf(piece));
        piece.folds = {foldAcross(piece, {0, 5, 0.4}, {0, 1, 0.4})};
        GarmentMesher mesher;
        QVERIFY(mesher.mesh(inputOf(piece)).has_value());
        piece.folds.clear();
        const auto again = mesher.mesh(inputOf(piece));
        QVERIFY(again.has_value());
        QVERIFY((*again)->pieces == plain->pieces);
    }

    void theMirroredTwinFoldsAlike() {
        PieceInput piece = bodicePiece(0.02);
        piece.folds = {foldAcross(piece, {0, 5, 0.4}, {0, 1, 0.4}),
                       foldAcross(piece, {0, 0, 0.3}, {0, 1, 0.1}, {{0.1, 0.05}})};
        PieceInput twin = piece;
        twin.mirrored = true;
        const Vec2 a{0.4, 0}, b{0.4, 1};
        std::reverse(twin.outline.begin(), twin.outline.end());
        for (BoundaryEdge& edge : twin.outline) edge.curve = geometry::reversed(geometry::mirrored(edge.curve, a, b));
        for (FoldInput& fold : twin.folds) {
            for (Vec2& point : fold.points) point = geometry::mirrored(point, a, b);
            for (FoldEndInput& end : fold.ends)
                end = {0, static_cast<int>(twin.outline.size()) - 1 - end.edge, 1 - end.fraction};
        }
        const auto garment = meshGarment({{piece, twin}, {}});
        QVERIFY2(garment.has_value(), garment ? "" : toString(garment.error()).c_str());
        QCOMPARE(garment->pieces[0].nodes.size(), garment->pieces[1].nodes.size());
        QCOMPARE(garment->pieces[0].folds, garment->pieces[1].folds);
        for (std::size_t i = 0; i < garment->pieces[0].nodes.size(); ++i)
            QVERIFY(distance(geometry::mirrored(garment->pieces[0].nodes[i], a, b), garment->pieces[1].nodes[i]) <
                    1e-12);
    }

    void whatIsNoFoldIsRefused_data() {
        QTest::addColumn<std::vector<FoldInput>>("folds");
        QTest::addColumn<QString>("text");
        const PieceInput strip = rectanglePiece(0.4, 0.1, 0.02);
        const FoldInput good = foldAcross(strip, {0, 0, 0.5}, {0, 2, 0.5});
        QTest::newRow("leaves the piece")
            << std::vector{foldAcross(strip, {0, 0, 0.5}, {0, 2, 0.5}, {{0.2, 0.15}})} << "leaves the piece";
        QTest::newRow("lies on the border") << std::vector{foldAcross(strip, {0, 0, 0.2}, {0, 0, 0.8})} << "border";
        QTest::newRow("ends where it begins")
            << std::vector{foldAcross(strip, {0, 0, 0.5}, {0, 0, 0.5}, {{0.2, 0.05}})} << "ends where it begins";
        QTest::newRow("folds cross") << std::vector{good, foldAcross(strip, {0, 0, 0.6}, {0, 2, 0.6})}
                                     << "crosses or touches fold";
        QTest::newRow("crosses itself") << std::vector{foldAcross(strip, {0, 0, 0.4}, {0, 2, 0.6},
                                                                  {{0.3, 0.06}, {0.3, 0.03}, {0.1, 0.05}})}
                                        << "itself";
        QTest::newRow("no such edge") << std::vector{FoldInput{"fold", good.points, {{{0, 0, 0.5}, {0, 9, 0.5}}}}}
                                      << "on the border";
    }
    void whatIsNoFoldIsRefused() {
        QFETCH(std::vector<FoldInput>, folds);
        QFETCH(QString, text);
        PieceInput piece = rectanglePiece(0.4, 0.1, 0.02);
        piece.folds = folds;
        const auto mesh = meshGarment(inputOf(piece));
        QVERIFY(!mesh.has_value());
        const QString said = QString::fromStdString(toString(mesh.error()));
        QVERIFY2(said.contains(text) && said.contains("fold \"fold\""), qPrintable(said));
    }
};

TOILE_TEST(tst_FoldedMesh, QCoreApplication)
#include "tst_FoldedMesh.moc"
