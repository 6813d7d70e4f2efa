// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "tests/Suite.h"
#include "ui/tools/DrawInternalLine.h"
#include "ui/tools/DrawPiece.h"
#include "ui/tools/EditPoints.h"
#include "ui/tools/MovePieces.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

class tst_DrawingTools : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void clicksAndTheFirstPointMakeAPiece();
    void enterClosesAsTheFirstPointDoes();
    void aDragMakesACurve();
    void backspaceTakesTheLastPointBack();
    void escapeDropsTheOutline();
    void twoPointsAreRefusedAndStay();
    void shiftKeepsEdgesOn45Degrees();
    void aDrawnPieceLiesWhereItWasDrawn();

    void draggingAVertexMovesItThere();
    void aDragIsOneStep();
    void draggingAHandleMovesItThere();
    void draggingAnEdgeMovesBothItsEnds();
    void shiftSelectsSeveralPoints();
    void doubleClickOnAnEdgeInsertsAPointThere();
    void deleteTakesSelectedPointsOut();

    void piecesMoveOnTheTableOnly();
    void internalLinesAreAddedToThePieceBelow();
};

void tst_DrawingTools::clicksAndTheFirstPointMakeAPiece() {
    DrawPiece tool;
    Hand hand{document::Document{}};
    for (const Vec2 at : {Vec2{0, 0}, {0.2, 0}, {0.2, 0.3}, {0, 0.3}, {0.001, 0.001}}) hand.click(tool, at);
    QCOMPARE(hand.document.pattern.pieces.size(), std::size_t(1));
    QCOMPARE(hand.piece(0).outline.vertices.size(), std::size_t(4));
    QVERIFY(hand.selection == Selection{hand.piece(0).id});
    QVERIFY(hand.overlay(tool).lines.empty()); // ready for the next one
}

void tst_DrawingTools::enterClosesAsTheFirstPointDoes() {
    DrawPiece tool;
    Hand hand{document::Document{}};
    for (const Vec2 at : {Vec2{0, 0}, {0.2, 0}, {0.2, 0.3}}) hand.click(tool, at);
    hand.key(tool, ToolKey::enter);
    QCOMPARE(hand.document.pattern.pieces.size(), std::size_t(1));
}

void tst_DrawingTools::aDragMakesACurve() {
    DrawPiece tool;
    Hand hand{document::Document{}};
    hand.click(tool, {0, 0});
    hand.drag(tool, {0.2, 0}, {0.2, 0.05});
    hand.click(tool, {0.1, 0.3});
    hand.key(tool, ToolKey::enter);
    const pattern::Contour& outline = hand.piece(0).outline;
    const auto* into = std::get_if<geometry::CubicShape>(&outline.edges[0].shape);
    QVERIFY(into);
    QVERIFY(std::holds_alternative<geometry::CubicShape>(outline.edges[1].shape));
    QVERIFY(std::holds_alternative<geometry::LineShape>(outline.edges[2].shape));
    const Vec2 handle = into->control2 - outline.vertices[1].position; // opposite the way of the drag
    QVERIFY(distance(handle, {0, -0.05}) < 1e-12);
}

void tst_DrawingTools::backspaceTakesTheLastPointBack() {
    DrawPiece tool;
    Hand hand{document::Document{}};
    for (const Vec2 at : {Vec2{0, 0}, {0.2, 0}, {0.9, 0.9}}) hand.click(tool, at);
    hand.key(tool, ToolKey::backspace);
    for (const Vec2 at : {Vec2{0.2, 0.3}, {0, 0.3}}) hand.click(tool, at);
    hand.key(tool, ToolKey::enter);
    QCOMPARE(hand.piece(0).outline.vertices.size(), std::size_t(4));
    const geometry::Box2 box = boundsOf(flattened(hand.document.pattern));
    QVERIFY(box.high.x < 0.21);
}

void tst_DrawingTools::escapeDropsTheOutline() {
    DrawPiece tool;
    Hand hand{document::Document{}};
    for (const Vec2 at : {Vec2{0, 0}, {0.2, 0}, {0.2, 0.3}}) hand.click(tool, at);
    hand.key(tool, ToolKey::escape);
    hand.key(tool, ToolKey::enter);
    QVERIFY(hand.document.pattern.pieces.empty());
}

void tst_DrawingTools::twoPointsAreRefusedAndStay() {
    DrawPiece tool;
    Hand hand{document::Document{}};
    hand.click(tool, {0, 0});
    hand.click(tool, {0.2, 0});
    hand.key(tool, ToolKey::enter);
    QVERIFY(hand.refused);
    QVERIFY(hand.document.pattern.pieces.empty());
    QVERIFY(!hand.overlay(tool).marks.empty());
}

void tst_DrawingTools::shiftKeepsEdgesOn45Degrees() {
    const Vec2 aligned = alignedTo45({1, 1}, {1.1, 1.11});
    QVERIFY(std::abs((aligned.x - 1) - (aligned.y - 1)) < 1e-12);
    QVERIFY(std::abs(alignedTo45({0, 0}, {0.3, 0.01}).y) < 1e-12);
}

void tst_DrawingTools::aDrawnPieceLiesWhereItWasDrawn() {
    DrawPiece tool;
    Hand hand{document::Document{}};
    for (const Vec2 at : {Vec2{1, 1}, {1.2, 1}, {1.2, 1.4}}) hand.click(tool, at);
    hand.key(tool, ToolKey::enter);
    const geometry::Box2 box = boundsOf(flattened(hand.document.pattern));
    QVERIFY(distance(box.low, {1, 1}) < 1e-12 && distance(box.high, {1.2, 1.4}) < 1e-12);
    QVERIFY(distance(hand.piece(0).tablePosition, {1.1, 1.2}) < 1e-12); // the origin is in the middle
}

void tst_DrawingTools::draggingAVertexMovesItThere() {
    EditPoints tool;
    Hand hand{twoRectangles()};
    hand.drag(tool, {0.401, 0.15}, {0.45, 0.2}); // a corner of the second piece
    const auto at = hand.piece(1).outline.vertices[2].position + hand.piece(1).tablePosition;
    QVERIFY(distance(at, Vec2{0.45, 0.2} - Vec2{0.001, 0}) < 1e-12); // it keeps where in it the hand took hold
}

void tst_DrawingTools::aDragIsOneStep() {
    EditPoints tool;
    Hand hand{twoRectangles()};
    hand.drag(tool, {0.1, 0.15}, {0.15, 0.2});
    QCOMPARE(hand.edits, 2);
    const std::string first = hand.lastKey;
    QVERIFY(!first.empty());
    hand.drag(tool, {0.15, 0.2}, {0.1, 0.2});
    QVERIFY(hand.lastKey != first); // another drag is another step
}

void tst_DrawingTools::draggingAHandleMovesItThere() {
    Hand hand{twoRectangles()};
    const pattern::PieceId piece = hand.piece(0).id;
    const pattern::EdgeId edge = hand.piece(0).outline.edges[1].id; // right side
    hand.document = *document::edited(hand.document, [&](const pattern::Pattern& p, pattern::IdSource&) {
        return setEdgeShape(p, piece, edge, geometry::CubicShape{{0.15, -0.05}, {0.15, 0.05}});
    });
    EditPoints tool;
    hand.drag(tool, {0.15, -0.05}, {0.18, -0.06});
    const auto& shape = std::get<geometry::CubicShape>(hand.piece(0).outline.edges[1].shape);
    QVERIFY(distance(shape.control1, {0.18, -0.06}) < 1e-12);
    QVERIFY(distance(shape.control2, {0.15, 0.05}) < 1e-12);
}

void tst_DrawingTools::draggingAnEdgeMovesBothItsEnds() {
    EditPoints tool;
    Hand hand{twoRectangles()};
    hand.drag(tool, {0.1, 0.02}, {0.13, 0.02}); // right side of the first piece
    const auto& vertices = hand.piece(0).outline.vertices;
    QVERIFY(std::abs(vertices[1].position.x - 0.13) < 1e-12 && std::abs(vertices[2].position.x - 0.13) < 1e-12);
    QVERIFY(std::abs(vertices[0].position.x + 0.1) < 1e-12);
}

void tst_DrawingTools::shiftSelectsSeveralPoints() {
    EditPoints tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, 0.15});
    hand.click(tool, {0.1, -0.15}, {.shift = true});
    QCOMPARE(hand.selection.size(), std::size_t(2));
    hand.click(tool, {0.1, -0.15}, {.shift = true});
    QCOMPARE(hand.selection.size(), std::size_t(1));
}

void tst_DrawingTools::doubleClickOnAnEdgeInsertsAPointThere() {
    EditPoints tool;
    Hand hand{twoRectangles()};
    hand.doubleClick(tool, {0.1, 0.03});
    QCOMPARE(hand.piece(0).outline.vertices.size(), std::size_t(5));
    const auto* selected = lastOf<VertexRef>(hand.selection);
    QVERIFY(selected);
    const auto place = placeOf(hand.piece(0), selected->vertex);
    QVERIFY(place);
    QVERIFY(distance(hand.piece(0).outline.vertices[place->vertex].position, {0.1, 0.03}) <
            1e-6); // search along the edge
}

void tst_DrawingTools::deleteTakesSelectedPointsOut() {
    EditPoints tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, 0.15});
    hand.key(tool, ToolKey::erase);
    QCOMPARE(hand.piece(0).outline.vertices.size(), std::size_t(3));
}

void tst_DrawingTools::piecesMoveOnTheTableOnly() {
    MovePieces tool;
    Hand hand{twoRectangles()};
    const auto outline = hand.piece(0).outline;
    hand.drag(tool, {0, 0}, {0.05, 0.1});
    QVERIFY(distance(hand.piece(0).tablePosition, {0.05, 0.1}) < 1e-12);
    QVERIFY(hand.piece(0).outline == outline);
    QVERIFY(distance(hand.piece(1).tablePosition, {0.3, 0}) < 1e-12);
}

void tst_DrawingTools::internalLinesAreAddedToThePieceBelow() {
    DrawInternalLine tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.25, 0});
    hand.click(tool, {0.35, 0.1});
    hand.key(tool, ToolKey::enter);
    QCOMPARE(hand.piece(1).internalLines.size(), std::size_t(1));
    QVERIFY(distance(hand.piece(1).internalLines[0].points[0], {-0.05, 0}) < 1e-12); // the piece's own coordinates
}

TOILE_TEST(tst_DrawingTools)
#include "tst_DrawingTools.moc"
