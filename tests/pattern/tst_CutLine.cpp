// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/CutLine.h"
#include "core/pattern/PatternMeasures.h"
#include "tests/Suite.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::pattern;

namespace {

double areaOfCut(const Piece& piece) {
    const std::vector<Area> areas = cutShape(piece);
    if (areas.size() != 1) return 0;
    double area = geometry::signedArea(areas[0].outline);
    for (const auto& hole : areas[0].holes) area += geometry::signedArea(hole);
    return area;
}

/// 300 × 400 mm with a seam allowance of 10 mm.
Piece panel() {
    Piece piece = tests::rectangle("panel", 0.3, 0.4);
    piece.seamAllowance = 0.01;
    return piece;
}

} // namespace

/// What is cut is the piece and its seam allowances, and nothing of the piece is lost.
class tst_CutLine : public QObject {
    Q_OBJECT
private slots:
    void rightAnglesAreMitred();
    void anEdgeOfItsOwnAllowanceMovesAlone();
    void withoutAllowanceThePieceIsCutAsItIsSewn();
    void sharpTipsAreCutOff();
    void insideCornersStaySharp();
    void holesGrowSmaller();
    void alongACurveTheCutLineIsParallel();
};

// Strips overlap by 1e-6 m, which at an edge without allowance stands out beside the neighbour's 40 mm.
constexpr double cutRounding = 1e-7;

void tst_CutLine::rightAnglesAreMitred() {
    QVERIFY(std::abs(areaOfCut(panel()) - (0.32 * 0.42)) < cutRounding);
    const auto [low, high] = geometry::boundsOf(cutShape(panel())[0].outline);
    QVERIFY(distance(low, {-0.01, -0.01}) < 2e-8 && distance(high, {0.31, 0.41}) < 2e-8);
}

void tst_CutLine::anEdgeOfItsOwnAllowanceMovesAlone() {
    Piece piece = panel();
    piece.outline.edges[0].seamAllowance = 0.04; // the hem
    piece.outline.edges[2].seamAllowance = 0;    // on the fold
    QVERIFY(std::abs(areaOfCut(piece) - (0.32 * 0.44)) < cutRounding);
}

void tst_CutLine::withoutAllowanceThePieceIsCutAsItIsSewn() {
    Piece piece = panel();
    piece.seamAllowance = 0;
    QVERIFY(std::abs(areaOfCut(piece) - (0.3 * 0.4)) < cutRounding);
}

void tst_CutLine::sharpTipsAreCutOff() {
    Piece piece = panel();
    piece.outline.vertices = {{VertexId("v1"), {0, 0}}, {VertexId("v2"), {0.4, -0.02}}, {VertexId("v3"), {0.4, 0.02}}};
    piece.outline.edges.pop_back();
    const auto cut = cutShape(piece);
    QCOMPARE(cut.size(), std::size_t(1));
    for (const Vec2 point : cut[0].outline)
        QVERIFY(geometry::distanceToBorder(std::vector<Vec2>{{0, 0}, {0.4, -0.02}, {0.4, 0.02}}, point) < 0.025 + 1e-8);
    QVERIFY(geometry::boundsOf(cut[0].outline).low.x > -0.0011); // 10 mm · sin 2.9°, beyond the tip's bevel
}

void tst_CutLine::insideCornersStaySharp() {
    Piece piece = panel(); // an L: 300 × 400 mm without its upper right quarter
    piece.outline.vertices = {{VertexId("v1"), {0, 0}},      {VertexId("v2"), {0.3, 0}},
                              {VertexId("v3"), {0.3, 0.2}},  {VertexId("v4"), {0.15, 0.2}},
                              {VertexId("v5"), {0.15, 0.4}}, {VertexId("v6"), {0, 0.4}}};
    while (piece.outline.edges.size() < 6) piece.outline.edges.push_back({EdgeId("more"), {}, {}});
    QVERIFY(std::abs(areaOfCut(piece) - (0.32 * 0.42 - 0.15 * 0.2)) < cutRounding);
}

void tst_CutLine::holesGrowSmaller() {
    Piece piece = panel();
    Contour hole = tests::rectangle("hole", 0.1, -0.1).outline; // mirrored: clockwise
    for (Vertex& vertex : hole.vertices) vertex.position += Vec2{0.1, 0.2};
    piece.holes = {hole};
    QVERIFY(std::abs(areaOfCut(piece) - (0.32 * 0.42 - 0.08 * 0.08)) < cutRounding);
}

void tst_CutLine::alongACurveTheCutLineIsParallel() {
    const Piece piece = *tests::twoPanels().pieces[0]; // its right edge is an S
    const auto cut = cutShape(piece);
    QCOMPARE(cut.size(), std::size_t(1));
    const geometry::Polygon stitched = flattened(piece.outline, 1e-5);
    for (const Vec2 point : cut[0].outline) {
        const double away = geometry::distanceToBorder(stitched, point);
        QVERIFY(away > piece.seamAllowance - 2e-4);                             // twice the chord error
        QVERIFY(away < piece.seamAllowance * std::numbers::sqrt2 * 1.2 + 2e-4); // mitres: corners of 75° and more
    }
}

TOILE_TEST(tst_CutLine)
#include "tst_CutLine.moc"
