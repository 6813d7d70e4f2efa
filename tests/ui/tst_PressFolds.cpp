// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "core/pattern/PatternFolds.h"
#include "core/pattern/PatternPieces.h"
#include "tests/Suite.h"
#include "ui/panels/PropertySheet.h"
#include "ui/pattern/PatternPainter.h"
#include "ui/tools/PressFolds.h"

#include <QImage>
#include <QTest>
#include <numbers>

using namespace toile;
using namespace toile::ui;

/// The tool for pressed folds, their sheet and their picture.
class tst_PressFolds : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void twoEdgesMakeAFold();
    void betweenThemItTurns();
    void elsewhereItIsRefused();
    void backspaceTakesTheLastPointBack();
    void anEndIsDraggedAlongTheBorder();
    void deleteTakesAFoldOut();
    void onAnImageItsSourceIsFolded();
    void theSheetSetsAngleAndStiffness();
    void aFoldIsDrawnDashDotted();
};

namespace {

// The front of two rectangles: 0.2 × 0.3 m round the origin, edges bottom, right, top, left.
const pattern::Fold& foldOf(const Hand& hand) {
    return hand.piece(0).folds[0];
}

Hand folded() {
    PressFolds tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, 0});
    hand.click(tool, {-0.1, 0});
    return hand;
}

} // namespace

void tst_PressFolds::twoEdgesMakeAFold() {
    PressFolds tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.101, 0.03});
    QVERIFY(hand.piece(0).folds.empty());
    hand.move(tool, {0, 0});
    QCOMPARE(hand.overlay(tool).lines.size(), std::size_t(1));
    hand.click(tool, {-0.099, -0.03});
    QCOMPARE(hand.piece(0).folds.size(), std::size_t(1));
    const std::vector<Vec2> line = pointsOf(hand.piece(0), foldOf(hand));
    QVERIFY(distance(line[0], {0.1, 0.03}) < 1e-6 && distance(line[1], {-0.1, -0.03}) < 1e-6); // search along the edge
    QCOMPARE(foldOf(hand).angle, -std::numbers::pi);
    QVERIFY((hand.selection == Selection{FoldRef{hand.piece(0).id, foldOf(hand).id}}));
    QVERIFY(hand.overlay(tool).lines.empty()); // ready for the next
}

void tst_PressFolds::betweenThemItTurns() {
    PressFolds tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, 0});
    hand.click(tool, {0, 0.05});
    hand.click(tool, {-0.1, 0});
    QCOMPARE(foldOf(hand).between.size(), std::size_t(1));
    QVERIFY(distance(foldOf(hand).between[0], {0, 0.05}) < 1e-12);
}

void tst_PressFolds::elsewhereItIsRefused() {
    PressFolds tool;
    Hand hand{twoRectangles()};
    hand.press(tool, {0, 0}); // no edge
    QVERIFY(hand.refused);
    hand.click(tool, {0.1, 0});
    hand.press(tool, {0.15, 0}); // no piece
    QVERIFY(hand.refused);
    hand.press(tool, {0.2, 0}); // another piece's edge
    QVERIFY(hand.refused);
    hand.press(tool, {0.1, 0.1}); // it would lie on the border
    QVERIFY(hand.refused);
    QVERIFY(hand.edits == 0);
    hand.key(tool, ToolKey::escape);
    QVERIFY(hand.overlay(tool).lines.empty());
}

void tst_PressFolds::backspaceTakesTheLastPointBack() {
    PressFolds tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, 0});
    hand.click(tool, {0, 0.05});
    hand.key(tool, ToolKey::backspace);
    hand.click(tool, {-0.1, 0});
    QVERIFY(foldOf(hand).between.empty());
}

void tst_PressFolds::anEndIsDraggedAlongTheBorder() {
    PressFolds tool;
    Hand hand = folded();
    hand.drag(tool, {-0.1, 0}, {-0.1, 0.1});
    QVERIFY(distance(pointsOf(hand.piece(0), foldOf(hand))[1], {-0.1, 0.1}) < 1e-6);
    QVERIFY(!hand.lastKey.empty());         // one step to undo
    hand.drag(tool, {-0.1, 0.1}, {0, 0.1}); // it stays on the border
    QVERIFY(std::abs(pointsOf(hand.piece(0), foldOf(hand))[1].x + 0.1) < 1e-6);
}

void tst_PressFolds::deleteTakesAFoldOut() {
    PressFolds tool;
    Hand hand = folded();
    hand.selection.clear();
    hand.click(tool, {0.02, 0.001}); // selects it
    QCOMPARE(hand.selection.size(), std::size_t(1));
    hand.key(tool, ToolKey::erase);
    QVERIFY(hand.piece(0).folds.empty());
}

void tst_PressFolds::onAnImageItsSourceIsFolded() {
    PressFolds tool;
    Hand hand{*document::edited(twoRectangles(), [](const pattern::Pattern& p, pattern::IdSource& ids) {
        return addMirrorPiece(p, p.pieces[0]->id, {0.1, 0}, {0.1, 1}, "Image", ids).and_then([](const auto& next) {
            return movePiece(next, next.pieces[2]->id, {0, 0.5});
        });
    })};
    hand.click(tool, {0.1, 0.55}); // the image spans 0.1 … 0.3
    hand.click(tool, {0.2, 0.5});
    hand.click(tool, {0.3, 0.5});
    QCOMPARE(hand.piece(0).folds.size(), std::size_t(1));
    const std::vector<Vec2> line = pointsOf(hand.piece(0), foldOf(hand));
    QVERIFY(distance(line[0], {0.1, 0.05}) < 1e-6);
    QVERIFY(distance(line[1], {0, 0}) < 1e-12);
    QVERIFY(distance(line[2], {-0.1, 0}) < 1e-6);
}

void tst_PressFolds::theSheetSetsAngleAndStiffness() {
    Hand hand = folded();
    const Item item = FoldRef{hand.piece(0).id, foldOf(hand).id};
    const auto rowOf = [&](const QString& name) {
        const FlatPattern flat = flattened(hand.document.pattern);
        const PropertySheet sheet = sheetOf({hand.document, flat, {item}}, {});
        return std::ranges::find(sheet.rows, name, &PropertyRow::name)->content;
    };
    hand.document = *std::get<NumberRow>(rowOf(QStringLiteral("foldAngle"))).set(hand.document, 1.5);
    hand.document = *std::get<NumberRow>(rowOf(QStringLiteral("stiffness"))).set(hand.document, 8.0);
    hand.document = *std::get<TextRow>(rowOf(QStringLiteral("name"))).set(hand.document, QStringLiteral("hem"));
    QCOMPARE(foldOf(hand).angle, 1.5);
    QCOMPARE(foldOf(hand).stiffnessFactor, 8.0);
    QCOMPARE(foldOf(hand).name, std::string("hem"));
    hand.document = *std::get<ActionRow>(rowOf(QStringLiteral("remove"))).act(hand.document);
    QVERIFY(hand.piece(0).folds.empty());
}

void tst_PressFolds::aFoldIsDrawnDashDotted() {
    const Hand hand = folded();
    const FlatPattern flat = flattened(hand.document.pattern);
    QImage image(400, 100, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    ViewTransform view;
    view.scale = 2000;
    view.size = {400, 100};
    const MeshLines none;
    const Overlay overlay;
    paintFolds(painter, view, flat.pieces[0], {hand.document.pattern, flat, none, {}, {}, overlay, {}});
    painter.end();
    int changes = 0;
    for (int x = 1; x < 400; ++x) changes += (qGray(image.pixel(x, 50)) < 128) != (qGray(image.pixel(x - 1, 50)) < 128);
    QVERIFY2(changes > 40, qPrintable(QString::number(changes))); // dashes and dots, not a line
}

TOILE_TEST(tst_PressFolds, QApplication)
#include "tst_PressFolds.moc"
