// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternFolds.h"
#include "tests/Suite.h"

#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternPieces.h"
#include "tests/pattern/ErrorsOf.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>
#include <cmath>
#include <numbers>

using namespace toile;
using namespace toile::pattern;
using tests::back;
using tests::errorsOf;
using tests::front;

class tst_PatternFolds : public QObject {
    Q_OBJECT
private slots:
    void aFoldIsAddedAndRemoved();
    void itRunsBetweenTwoPlacesOfTheBorder();
    void whatIsNoFoldIsRefused_data();
    void whatIsNoFoldIsRefused();
    void angleAndStiffnessAreSet();
    void anEndMovesAlongTheBorder();
    void aSplitEdgeKeepsTheFoldWhereItIs();
    void anImageShowsItsSourcesFold();
    void aCopyFoldsAlongItsOwnEdges();
    void aFoldGoesWithTheHoleThatItEndsOn();
    void aFoldThatTheBorderHasLeftIsNamed();
    void foldsThatCrossAreNamed();
};

namespace {

const FoldId crease("l50");

/// Two panels, the back folded level in the middle.
Pattern folded() {
    IdSource ids{50};
    return *addFold(tests::twoPanels(), back, {{{EdgeId("right"), 0.5}, {EdgeId("left"), 0.5}}}, {}, 1.5, "crease",
                    ids);
}

const Fold& foldOf(const Pattern& pattern, const PieceId& piece = back) {
    return findPiece(pattern, piece)->folds.front();
}

} // namespace

void tst_PatternFolds::aFoldIsAddedAndRemoved() {
    const Pattern pattern = folded();
    QVERIFY(errorsOf(pattern).empty());
    const Fold* fold = findFold(*findPiece(pattern, back), crease);
    QVERIFY(fold && fold->name == "crease" && fold->angle == 1.5 && fold->stiffnessFactor == 1);
    QVERIFY(*removeFold(pattern, back, crease) == tests::twoPanels());
    QVERIFY(!removeFold(tests::twoPanels(), back, crease));
    QCOMPARE(firstFreeNumber(pattern), 51);
}

void tst_PatternFolds::itRunsBetweenTwoPlacesOfTheBorder() {
    const Pattern pattern = folded();
    const std::vector<Vec2> line = pointsOf(*findPiece(pattern, back), foldOf(pattern));
    QCOMPARE(line.size(), std::size_t(2));
    QVERIFY(distance(line[0], {0.3, 0.2}) < 1e-12 && distance(line[1], {0, 0.2}) < 1e-12);
}

void tst_PatternFolds::whatIsNoFoldIsRefused_data() {
    using Ends = std::array<BorderPoint, 2>;
    QTest::addColumn<Ends>("ends");
    QTest::addColumn<std::vector<Vec2>>("between");
    QTest::addColumn<double>("angle");
    const Ends level{{{EdgeId("right"), 0.5}, {EdgeId("left"), 0.5}}};
    QTest::newRow("an edge that is not there")
        << Ends{{{EdgeId("right"), 0.5}, {EdgeId("sleeve"), 0.5}}} << std::vector<Vec2>{} << 1.0;
    QTest::newRow("beyond the edge") << Ends{{{EdgeId("right"), 1.5}, {EdgeId("left"), 0.5}}} << std::vector<Vec2>{}
                                     << 1.0;
    QTest::newRow("ends where it begins") << Ends{{level[0], level[0]}} << std::vector<Vec2>{} << 1.0;
    QTest::newRow("leaves the piece") << level << std::vector<Vec2>{{0.15, 0.5}} << 1.0;
    for (const char* edge : {"bottom", "right", "top", "left"})
        QTest::addRow("along the border, %s", edge)
            << Ends{{{EdgeId(edge), 0.2}, {EdgeId(edge), 0.8}}} << std::vector<Vec2>{} << 1.0;
    QTest::newRow("along the border, then inside")
        << Ends{{{EdgeId("bottom"), 0.2}, {EdgeId("top"), 0.5}}} << std::vector<Vec2>{{0.15, 0}} << 1.0;
    QTest::newRow("crosses itself") << level << std::vector<Vec2>{{0.1, 0.1}, {0.1, 0.3}, {0.2, 0.15}} << 1.0;
    QTest::newRow("more than folded") << level << std::vector<Vec2>{} << 4.0;
    QTest::newRow("no number") << level << std::vector<Vec2>{{0.1, std::nan("")}} << 1.0;
}
void tst_PatternFolds::whatIsNoFoldIsRefused() {
    using Ends = std::array<BorderPoint, 2>;
    QFETCH(Ends, ends);
    QFETCH(std::vector<Vec2>, between);
    QFETCH(double, angle);
    IdSource ids{50};
    const auto refused = addFold(tests::twoPanels(), back, ends, between, angle, "crease", ids);
    QVERIFY(!refused);
    QCOMPARE(refused.error().place.object, std::string("piece \"back\", fold \"crease\""));
}

void tst_PatternFolds::angleAndStiffnessAreSet() {
    Pattern pattern = *pressFold(folded(), back, crease, -std::numbers::pi);
    pattern = *setFoldStiffness(pattern, back, crease, 5);
    pattern = *renameFold(pattern, back, crease, "pleat");
    QCOMPARE(foldOf(pattern).angle, -std::numbers::pi);
    QCOMPARE(foldOf(pattern).stiffnessFactor, 5.0);
    QCOMPARE(foldOf(pattern).name, std::string("pleat"));
    QVERIFY(!pressFold(pattern, back, crease, 4));
    QVERIFY(!setFoldStiffness(pattern, back, crease, 0));
    QVERIFY(!pressFold(pattern, back, FoldId("l7"), 1));
}

void tst_PatternFolds::anEndMovesAlongTheBorder() {
    const Pattern pattern = *moveFoldEnd(folded(), back, crease, 1, {EdgeId("top"), 0.25});
    QVERIFY(distance(pointsOf(*findPiece(pattern, back), foldOf(pattern))[1], {0.225, 0.4}) < 1e-12);
    QVERIFY(!moveFoldEnd(pattern, back, crease, 1, {EdgeId("right"), 0.75})); // it would lie on the border
}

void tst_PatternFolds::aSplitEdgeKeepsTheFoldWhereItIs() {
    IdSource ids{60};
    for (const double at : {0.25, 0.75}) {
        const Pattern split = *insertVertex(folded(), back, EdgeId("right"), at, ids);
        QVERIFY(errorsOf(split).empty());
        QVERIFY(distance(pointsOf(*findPiece(split, back), foldOf(split))[0], {0.3, 0.2}) < 1e-12);
        const VertexId added = findPiece(split, back)->outline.vertices[2].id;
        const Pattern joined = deleteVertex(split, back, added)->pattern;
        QVERIFY(distance(pointsOf(*findPiece(joined, back), foldOf(joined))[0], {0.3, 0.2}) < 1e-12);
    }
}

void tst_PatternFolds::anImageShowsItsSourcesFold() {
    IdSource ids{50};
    const Pattern pattern = *addFold(tests::twoPanels(), front, {{{EdgeId("bottom"), 0.25}, {EdgeId("top"), 0.25}}},
                                     {{0.1, 0.2}}, 1, "crease", ids);
    const Piece image = resolved(pattern, *findPiece(pattern, PieceId("image")));
    const std::vector<Vec2> line = pointsOf(*findPiece(pattern, front), foldOf(pattern, front)),
                            reflected = pointsOf(image, image.folds.front());
    QCOMPARE(reflected.size(), line.size());
    for (std::size_t i = 0; i < line.size(); ++i) QVERIFY(distance(reflected[i], {-line[i].x, line[i].y}) < 1e-12);
    QCOMPARE(image.folds.front().angle, 1.0);                // the same side of the cloth closes
    QVERIFY(!removeFold(pattern, PieceId("image"), crease)); // it is the source's
}

void tst_PatternFolds::aCopyFoldsAlongItsOwnEdges() {
    IdSource ids{60};
    const Pattern pattern = *duplicatePiece(folded(), back, "copy", ids);
    const Piece& copy = *pattern.pieces.back();
    QVERIFY(errorsOf(pattern).empty());
    QVERIFY(copy.folds.front().id != crease);
    QCOMPARE(copy.folds.front().ends[0].edge, copy.outline.edges[1].id);
}

void tst_PatternFolds::aFoldGoesWithTheHoleThatItEndsOn() {
    IdSource ids{60};
    const std::vector<Vec2> corners{{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.3}, {0.1, 0.3}};
    Pattern pattern = *addHole(tests::twoPanels(), back, corners, ids);
    const Contour& hole = findPiece(pattern, back)->holes[0];
    std::size_t facing = 0; // the side at x = 0.2
    while (hole.vertices[facing].position.x < 0.15 || hole.vertices[(facing + 1) % 4].position.x < 0.15) ++facing;
    pattern = *addFold(pattern, back, {{{EdgeId("right"), 0.5}, {hole.edges[facing].id, 0.5}}}, {}, 1, "crease", ids);
    QVERIFY(errorsOf(pattern).empty());
    const Edited without = *deleteHole(pattern, back, 0);
    QVERIFY(findPiece(without.pattern, back)->folds.empty());
    QCOMPARE(without.warnings.size(), std::size_t(1));
    QCOMPARE(without.warnings[0].place, std::string("piece \"back\", fold \"crease\""));
}

void tst_PatternFolds::aFoldThatTheBorderHasLeftIsNamed() {
    IdSource ids{60};
    Pattern pattern = folded();
    pattern = *insertVertex(pattern, back, EdgeId("top"), 0.5, ids);
    pattern = *moveVertex(pattern, back, findPiece(pattern, back)->outline.vertices[3].id, {0.15, 0.1});
    const auto errors = errorsOf(pattern);
    QCOMPARE(errors.size(), std::size_t(1));
    QVERIFY2(errors[0].find("pieces[1].folds[0].between: piece \"back\": The fold \"crease\" leaves the piece at") !=
                 std::string::npos,
             errors[0].c_str());
}

void tst_PatternFolds::foldsThatCrossAreNamed() {
    IdSource ids{60};
    const Pattern pattern =
        *addFold(folded(), back, {{{EdgeId("bottom"), 0.5}, {EdgeId("top"), 0.5}}}, {}, 1, "other", ids);
    const auto errors = errorsOf(pattern);
    QCOMPARE(errors.size(), std::size_t(1));
    QVERIFY2(errors[0].find("The fold \"other\" crosses the fold \"crease\" at (150.00, 200.00) mm.") !=
                 std::string::npos,
             errors[0].c_str());
}

TOILE_TEST(tst_PatternFolds)
#include "tst_PatternFolds.moc"
