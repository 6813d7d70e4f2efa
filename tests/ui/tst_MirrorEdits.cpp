// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "tests/Suite.h"
#include "ui/panels/PropertySheet.h"
#include "ui/tools/CutDart.h"
#include "ui/tools/CutHole.h"
#include "ui/tools/DrawInternalLine.h"
#include "ui/tools/EditNotches.h"
#include "ui/tools/EditPoints.h"
#include "ui/tools/PaintRegion.h"
#include "ui/values/ShapeOwner.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

/// What is done to a mirror image is done to its source, so that it is seen where it was done.
class tst_MirrorEdits : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void thePieceSheetAddsAnImage();
    void aDraggedPointFollowsThePointer();
    void aDraggedHandleFollowsThePointer();
    void aPointOfBothIsMovedOnce();
    void pointsAreInsertedAndDeleted();
    void aRegionIsPaintedWhereItIsPainted();
    void aNotchIsSetWhereItIsClicked();
    void aDartAndAHoleAreCutWhereTheyAreDrawn();
};

namespace {

/// The front of 200 × 300 mm about the origin, and its image about x = 400 mm.
Hand withImage() {
    Hand hand{withRectangle({}, "Front", {0, 0}, 0.2, 0.3)};
    hand.document = *document::edited(hand.document, [&](const pattern::Pattern& p, pattern::IdSource& ids) {
        return addMirrorPiece(p, hand.piece(0).id, {0, 0}, {0, 1}, "Image", ids)
            .and_then([&](const pattern::Pattern& with) {
                return movePiece(with, with.pieces[1]->id, {0.4, 0});
            });
    });
    return hand;
}

/// As the image is drawn.
FlatPiece image(const Hand& hand) {
    return flattened(hand.document.pattern).pieces[1];
}

bool hasCorner(const FlatPiece& piece, Vec2 at) {
    return std::ranges::any_of(piece.piece.outline.vertices,
                               [&](const auto& v) { return distance(v.position, at) < 1e-9; });
}

} // namespace

void tst_MirrorEdits::thePieceSheetAddsAnImage() {
    Hand hand{withRectangle({}, "Front", {0, 0}, 0.2, 0.3)};
    const FlatPattern flat = flattened(hand.document.pattern);
    const PropertySheet sheet = sheetOf({hand.document, flat, {hand.piece(0).id}}, {});
    const auto row = std::ranges::find(sheet.rows, QStringLiteral("addMirror"), &PropertyRow::name);
    QVERIFY(row != sheet.rows.end());
    hand.document = *std::get<ActionRow>(row->content).act(hand.document);
    QCOMPARE(hand.document.pattern.pieces.size(), std::size_t(2));
    QVERIFY(hasCorner(image(hand), {0.15, 0.15})); // 50 mm beside it
    QVERIFY(hasCorner(image(hand), {0.35, 0.15}));
}

void tst_MirrorEdits::aDraggedPointFollowsThePointer() {
    EditPoints tool;
    Hand hand = withImage();
    hand.drag(tool, {0.3, 0.15}, {0.32, 0.17});
    QVERIFY(hasCorner(image(hand), {0.32, 0.17}));
    QVERIFY(distance(hand.piece(0).outline.vertices[2].position, {0.08, 0.17}) < 1e-9); // the source's opposite corner
}

void tst_MirrorEdits::aDraggedHandleFollowsThePointer() {
    EditPoints tool;
    Hand hand = withImage();
    const auto& source = hand.piece(0);
    hand.document =
        *document::edited(hand.document, [&](const pattern::Pattern& p, pattern::IdSource&) { // its right side
            return setEdgeShape(p, source.id, source.outline.edges[1].id,
                                geometry::CubicShape{{0.12, -0.05}, {0.12, 0.05}});
        });
    hand.drag(tool, {0.28, 0.05}, {0.25, 0.06});
    const auto& shape = std::get<geometry::CubicShape>(hand.piece(0).outline.edges[1].shape);
    QVERIFY(distance(shape.control2, {0.15, 0.06}) < 1e-9);
    QVERIFY(distance(shape.control1, {0.12, -0.05}) < 1e-9);
}

void tst_MirrorEdits::aPointOfBothIsMovedOnce() {
    EditPoints tool;
    Hand hand = withImage();
    const auto vertex = hand.piece(0).outline.vertices[2].id;
    hand.selection = {VertexRef{hand.piece(0).id, vertex}, VertexRef{hand.piece(1).id, vertex}};
    hand.drag(tool, {0.1, 0.15}, {0.1, 0.17});
    QVERIFY(distance(hand.piece(0).outline.vertices[2].position, {0.1, 0.17}) < 1e-9);
}

void tst_MirrorEdits::pointsAreInsertedAndDeleted() {
    EditPoints tool;
    Hand hand = withImage();
    hand.doubleClick(tool, {0.3, 0.05});
    QVERIFY(std::ranges::any_of(image(hand).piece.outline.vertices, [](const auto& v) {
        return distance(v.position, {0.3, 0.05}) < 1e-6;
    })); // search along the edge
    QCOMPARE(hand.selection.size(), std::size_t(1));
    hand.key(tool, ToolKey::erase);
    QCOMPARE(hand.piece(0).outline.vertices.size(), std::size_t(4));
}

void tst_MirrorEdits::aRegionIsPaintedWhereItIsPainted() {
    PaintOptions options;
    options.radius = 0.02;
    PaintBrush brush(options);
    PaintPolygon polygon(options);
    Hand hand = withImage();
    hand.drag(brush, {0.35, 0.1}, {0.36, 0.1});
    QVERIFY(regionAt(flattened(hand.document.pattern), {0.355, 0.1}) && !hand.piece(0).regions.empty());
    QVERIFY(hand.selection == (Selection{RegionRef{hand.piece(1).id, hand.piece(0).regions[0].id}}));
    hand.drag(brush, {0.36, 0.1}, {0.40, 0.1}); // the same one grows
    QCOMPARE(hand.piece(0).regions.size(), std::size_t(1));
    for (const Vec2 corner : {Vec2{0.42, -0.1}, {0.46, -0.1}, {0.46, -0.05}}) hand.click(polygon, corner);
    hand.key(polygon, ToolKey::enter);
    QCOMPARE(hand.piece(0).regions.size(), std::size_t(2));
    QVERIFY(regionAt(flattened(hand.document.pattern), {0.455, -0.09}));
    hand.key(polygon, ToolKey::erase);
    QCOMPARE(hand.piece(0).regions.size(), std::size_t(1));
}

void tst_MirrorEdits::aNotchIsSetWhereItIsClicked() {
    EditNotches tool;
    Hand hand = withImage();
    hand.press(tool, {0.3, 0.06});
    const FlatPiece seen = image(hand);
    QCOMPARE(seen.piece.notches.size(), std::size_t(1));
    const auto place = placeOf(seen.piece, seen.piece.notches[0].edge);
    QVERIFY(distance(pointAlong(seen.outline.edges[place->edge], seen.piece.notches[0].position).position,
                     {0.3, 0.06}) < 1e-6);
}

void tst_MirrorEdits::aDartAndAHoleAreCutWhereTheyAreDrawn() {
    DartOptions options{0.02};
    CutDart dart(options);
    CutHole hole;
    DrawInternalLine line;
    Hand hand = withImage();
    hand.click(dart, {0.35, 0.15});
    hand.click(dart, {0.36, 0.05});
    QVERIFY(hasCorner(image(hand), {0.36, 0.05}));
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(2)); // both are sewn
    for (const Vec2 corner : {Vec2{0.45, -0.1}, {0.48, -0.1}, {0.48, -0.05}}) hand.click(hole, corner);
    hand.key(hole, ToolKey::enter);
    QVERIFY(!covers(image(hand), {0.475, -0.09}));
    hand.click(line, {0.45, 0});
    hand.click(line, {0.45, 0.1});
    hand.key(line, ToolKey::enter);
    QVERIFY(distance(image(hand).piece.internalLines[0].points[1], {0.45, 0.1}) < 1e-9);
}

TOILE_TEST(tst_MirrorEdits, QApplication)
#include "tst_MirrorEdits.moc"
