// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "core/pattern/PatternMeasures.h"
#include "tests/Suite.h"
#include "ui/panels/PropertySheet.h"
#include "ui/tools/CutDart.h"
#include "ui/tools/CutHole.h"
#include "ui/tools/EditNotches.h"
#include "ui/tools/SetTacks.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

/// Notches, darts, holes and pins: tools, and the rows of their sheets.
class tst_DetailTools : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aClickSetsANotch();
    void nearTheMiddleItIsTheMiddle();
    void shiftSetsADoubleNotch();
    void altTakesANotchOut();
    void aNotchIsNotSetTwice();
    void theEdgeSheetChangesANotch();

    void twoClicksCutADart();
    void shiftKeepsADartUpright();
    void aDartThatDoesNotFitIsRefusedAndKept();

    void cornersCutAHole();
    void aHoleReachesNotBeyondItsPiece();
    void theEdgeSheetDeletesAHole();
    void whatGoesWithAHoleIsNamed();

    void theVertexSheetPins();

    void twoClicksSetATack();
    void besideThePiecesNothingIsTacked();
    void anEndIsDragged();
    void deleteTakesATackOut();
    void whatGoesWithAPieceIsNamed();
    void onAnImageATackCountsInTheImage();
    void theSheetMakesAButton();
};

namespace {

constexpr Modifiers alt{.alt = true};

/// Uses the row of a sheet as the property editor does.
template <class Row, class... Value>
void use(Hand& hand, const Item& item, const QString& name, Value... value) {
    const FlatPattern flat = flattened(hand.document.pattern);
    const PropertySheet sheet = sheetOf({hand.document, flat, {item}}, {});
    const auto row = std::ranges::find(sheet.rows, name, &PropertyRow::name);
    QVERIFY2(row != sheet.rows.end(), qPrintable(name));
    const auto result = [&] {
        if constexpr (sizeof...(value) == 0) return std::get<Row>(row->content).act(hand.document);
        else return std::get<Row>(row->content).set(hand.document, value...);
    }();
    QVERIFY(result);
    hand.document = *result;
}

EdgeRef edgeOf(const Hand& hand, std::size_t edge) {
    return {hand.piece(0).id, hand.piece(0).outline.edges[edge].id};
}

const std::array holeCorners{Vec2{-0.03, -0.03}, Vec2{0.03, -0.03}, Vec2{0.03, 0.03}, Vec2{-0.03, 0.03}};

} // namespace

void tst_DetailTools::aClickSetsANotch() {
    EditNotches tool;
    Hand hand{twoRectangles()};
    hand.move(tool, {0.1, -0.075}); // a quarter up the right side
    QCOMPARE(hand.overlay(tool).labels.size(), std::size_t(1));
    QVERIFY(hand.overlay(tool).labels[0].text.contains(QStringLiteral("75.0 mm and 225.0 mm")));
    hand.press(tool, {0.1, -0.075});
    QCOMPARE(hand.piece(0).notches.size(), std::size_t(1));
    QCOMPARE(hand.piece(0).notches[0].edge, hand.piece(0).outline.edges[1].id);
    QVERIFY(std::abs(hand.piece(0).notches[0].position - 0.25) < 1e-6); // search along the edge
    QVERIFY(!hand.piece(0).notches[0].isDouble);
    QVERIFY(hand.selection == Selection{edgeOf(hand, 1)});
}

void tst_DetailTools::nearTheMiddleItIsTheMiddle() {
    EditNotches tool;
    Hand hand{twoRectangles()};
    hand.press(tool, {0.1, 0.002});
    QCOMPARE(hand.piece(0).notches[0].position, 0.5);
}

void tst_DetailTools::shiftSetsADoubleNotch() {
    EditNotches tool;
    Hand hand{twoRectangles()};
    hand.press(tool, {0.1, 0}, shift);
    QVERIFY(hand.piece(0).notches[0].isDouble);
}

void tst_DetailTools::altTakesANotchOut() {
    EditNotches tool;
    Hand hand{twoRectangles()};
    hand.press(tool, {0.1, 0});
    hand.press(tool, {0.1, 0.1}, alt);
    QVERIFY(hand.refused); // there is none
    hand.press(tool, {0.1, 0.002}, alt);
    QVERIFY(hand.piece(0).notches.empty());
}

void tst_DetailTools::aNotchIsNotSetTwice() {
    EditNotches tool;
    Hand hand{twoRectangles()};
    hand.press(tool, {0.1, 0});
    hand.press(tool, {0.1, 0});
    QVERIFY(hand.refused);
    QCOMPARE(hand.piece(0).notches.size(), std::size_t(1));
}

void tst_DetailTools::theEdgeSheetChangesANotch() {
    EditNotches tool;
    Hand hand{twoRectangles()};
    hand.press(tool, {0.1, 0});
    hand.press(tool, {0.1, 0.1});
    const EdgeRef edge = edgeOf(hand, 1);
    use<NumberRow>(hand, edge, QStringLiteral("notch2Position"), 0.03);
    QVERIFY(std::abs(hand.piece(0).notches[1].position - 0.1) < 1e-9); // 30 of 300 mm
    use<ChoiceRow>(hand, edge, QStringLiteral("notch2Kind"), 2);
    QVERIFY(hand.piece(0).notches[1].kind == pattern::NotchKind::t);
    use<FlagRow>(hand, edge, QStringLiteral("notch2Double"), true);
    QVERIFY(hand.piece(0).notches[1].isDouble);
    use<ActionRow>(hand, edge, QStringLiteral("notch1Remove"));
    QCOMPARE(hand.piece(0).notches.size(), std::size_t(1));
    QVERIFY(hand.piece(0).notches[0].isDouble);
}

void tst_DetailTools::twoClicksCutADart() {
    DartOptions options{0.02};
    CutDart tool(options);
    Hand hand{twoRectangles()};
    hand.click(tool, {0, 0.15}); // the middle of the waist
    hand.move(tool, {0.01, 0.05});
    QVERIFY(hand.overlay(tool).labels[0].text.contains(QStringLiteral("20.0 mm wide")));
    hand.click(tool, {0.01, 0.05});
    QCOMPARE(hand.edits, 1);
    QCOMPARE(hand.piece(0).outline.edges.size(), std::size_t(7));
    QVERIFY(std::abs(areaOf(hand.piece(0)) - (0.06 - 0.02 * 0.1 / 2)) < 1e-9);
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
    QVERIFY(hand.selection == Selection{hand.document.pattern.seams[0].id});
    QCOMPARE(hand.document.pattern.seams[0].name, std::string("Dart 1"));
}

void tst_DetailTools::shiftKeepsADartUpright() {
    DartOptions options{0.02};
    CutDart tool(options);
    Hand hand{twoRectangles()};
    hand.click(tool, {0.02, 0.15});
    hand.click(tool, {0.05, 0.05}, shift);
    const auto& vertices = hand.piece(0).outline.vertices;
    QVERIFY(std::ranges::any_of(vertices, [](const auto& v) { return distance(v.position, {0.02, 0.05}) < 1e-6; }));
}

void tst_DetailTools::aDartThatDoesNotFitIsRefusedAndKept() {
    DartOptions options{0.02};
    CutDart tool(options);
    Hand hand{twoRectangles()};
    hand.click(tool, {0, 0.15});
    hand.press(tool, {0, 0.3}); // outside
    QVERIFY(hand.refused);
    hand.click(tool, {0, 0.05}); // the mouth is still there
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
}

void tst_DetailTools::cornersCutAHole() {
    CutHole tool;
    Hand hand{twoRectangles()};
    for (const Vec2 corner : holeCorners) hand.click(tool, corner);
    hand.key(tool, ToolKey::enter);
    QCOMPARE(hand.piece(0).holes.size(), std::size_t(1));
    QVERIFY(std::abs(areaOf(hand.piece(0)) - (0.06 - 0.0036)) < 1e-9);
}

void tst_DetailTools::aHoleReachesNotBeyondItsPiece() {
    CutHole tool;
    Hand hand{twoRectangles()};
    for (const Vec2 corner : {Vec2{0, 0}, {0.05, 0}, {0.15, 0.05}}) hand.click(tool, corner);
    hand.key(tool, ToolKey::enter);
    QVERIFY(hand.refused);
    QVERIFY(hand.piece(0).holes.empty());
}

void tst_DetailTools::theEdgeSheetDeletesAHole() {
    CutHole tool;
    Hand hand{twoRectangles()};
    for (const Vec2 corner : holeCorners) hand.click(tool, corner);
    hand.key(tool, ToolKey::enter);
    use<ActionRow>(hand, EdgeRef{hand.piece(0).id, hand.piece(0).holes[0].edges[2].id}, QStringLiteral("removeHole"));
    QVERIFY(hand.piece(0).holes.empty());
}

void tst_DetailTools::whatGoesWithAHoleIsNamed() {
    CutHole tool;
    Hand hand{twoRectangles()};
    for (const Vec2 corner : holeCorners) hand.click(tool, corner);
    hand.key(tool, ToolKey::enter);
    const EdgeRef edge{hand.piece(0).id, hand.piece(0).holes[0].edges[2].id};
    hand.document.pattern.seams.push_back(
        {pattern::SeamId("s90"),
         "pocket",
         {{{{hand.piece(0).id, edge.edge}}, {{hand.piece(1).id, edgeOf(hand, 0).edge}}}}});
    hand.feed([&](const Desk& desk) {
        const PropertySheet sheet = edgeSheet(desk, edge);
        const auto row = std::ranges::find(sheet.rows, QStringLiteral("removeHole"), &PropertyRow::name);
        return effectOf(row->label, std::get<ActionRow>(row->content), desk.document);
    });
    QVERIFY(hand.piece(0).holes.empty());
    QCOMPARE(hand.message, QStringLiteral("seam \"pocket\": it is gone with the hole that it ran along."));
}

void tst_DetailTools::theVertexSheetPins() {
    Hand hand{twoRectangles()};
    const VertexRef corner{hand.piece(1).id, hand.piece(1).outline.vertices[2].id};
    use<FlagRow>(hand, corner, QStringLiteral("pinned"), true);
    QCOMPARE(hand.document.pattern.pins.size(), std::size_t(1));
    QCOMPARE(hand.document.pattern.pins[0].vertex, corner.vertex);
    QVERIFY(!hand.document.pattern.pins[0].toBody);
    use<FlagRow>(hand, corner, QStringLiteral("pinnedToBody"), true);
    QVERIFY(hand.document.pattern.pins[0].toBody);
    use<FlagRow>(hand, corner, QStringLiteral("pinnedToBody"), false);
    QVERIFY(!hand.document.pattern.pins[0].toBody);
    use<FlagRow>(hand, corner, QStringLiteral("pinned"), false);
    QVERIFY(hand.document.pattern.pins.empty());
}

void tst_DetailTools::twoClicksSetATack() {
    SetTacks tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.02, 0.05});
    QVERIFY(hand.document.pattern.tacks.empty());
    QCOMPARE(hand.overlay(tool).marks.size(), std::size_t(1));
    hand.click(tool, {0.31, 0.04});
    QCOMPARE(hand.document.pattern.tacks.size(), std::size_t(1));
    const pattern::Tack& tack = hand.document.pattern.tacks[0];
    QVERIFY(tack.ends[0].piece == hand.piece(0).id && tack.ends[1].piece == hand.piece(1).id);
    QVERIFY(distance(tack.ends[0].point, {0.02, 0.05}) < 1e-12 && distance(tack.ends[1].point, {0.01, 0.04}) < 1e-12);
    QVERIFY(hand.selection == Selection{tack.id});
    QVERIFY(hand.overlay(tool).marks.empty()); // ready for the next
}

void tst_DetailTools::besideThePiecesNothingIsTacked() {
    SetTacks tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.15, 0});
    QVERIFY(hand.edits == 0);
    hand.click(tool, {0, 0});
    hand.press(tool, {0.15, 0});
    QVERIFY(hand.refused);
    hand.press(tool, {0, 0}); // the same place
    QVERIFY(hand.refused);
    hand.key(tool, ToolKey::escape);
    hand.click(tool, {0.3, 0}); // begins anew
    QVERIFY(hand.document.pattern.tacks.empty());
}

void tst_DetailTools::anEndIsDragged() {
    SetTacks tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0, 0});
    hand.click(tool, {0.3, 0});
    hand.drag(tool, {0.301, 0.001}, {0.32, 0.05});
    QCOMPARE(hand.document.pattern.tacks.size(), std::size_t(1));
    QVERIFY(distance(hand.document.pattern.tacks[0].ends[1].point, {0.02, 0.05}) < 1e-12);
    QVERIFY(!hand.lastKey.empty()); // one step to undo
    hand.drag(tool, {0.32, 0.05}, {0.45, 0.05});
    QVERIFY(hand.document.pattern.tacks[0].ends[1].point.x <= 0.1); // it stays on its piece
}

void tst_DetailTools::deleteTakesATackOut() {
    SetTacks tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0, 0});
    hand.click(tool, {0.3, 0});
    hand.click(tool, {0, 0}); // selects it
    QCOMPARE(hand.document.pattern.tacks.size(), std::size_t(1));
    hand.key(tool, ToolKey::erase);
    QVERIFY(hand.document.pattern.tacks.empty());
}

void tst_DetailTools::whatGoesWithAPieceIsNamed() {
    SetTacks tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0, 0});
    hand.click(tool, {0.3, 0});
    hand.document.pattern.tacks[0].name = "button";
    hand.selection = {hand.piece(1).id};
    hand.key(tool, ToolKey::erase);
    QVERIFY(hand.document.pattern.tacks.empty());
    QCOMPARE(hand.message, QStringLiteral("tack \"button\": it is gone with the piece \"Back\"."));
}

void tst_DetailTools::onAnImageATackCountsInTheImage() {
    SetTacks tool;
    Hand hand{*document::edited(twoRectangles(), [](const pattern::Pattern& p, pattern::IdSource& ids) {
        return addMirrorPiece(p, p.pieces[0]->id, {0.1, 0}, {0.1, 1}, "Image", ids).and_then([](const auto& next) {
            return movePiece(next, next.pieces[2]->id, {0, 0.5});
        });
    })};
    hand.click(tool, {0, 0});
    hand.click(tool, {0.18, 0.52});
    QCOMPARE(hand.document.pattern.tacks.size(), std::size_t(1));
    QVERIFY(distance(hand.document.pattern.tacks[0].ends[1].point, {0.18, 0.02}) < 1e-12);
}

void tst_DetailTools::theSheetMakesAButton() {
    SetTacks tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0, 0});
    hand.click(tool, {0.3, 0});
    const Item tack = hand.selection[0];
    use<FlagRow>(hand, tack, QStringLiteral("button"), true);
    QVERIFY(hand.document.pattern.tacks[0].buttonDiameter);
    use<NumberRow>(hand, tack, QStringLiteral("diameter"), 0.02);
    use<NumberRow>(hand, tack, QStringLiteral("bY"), 0.03);
    QCOMPARE(*hand.document.pattern.tacks[0].buttonDiameter, 0.02);
    QCOMPARE(hand.document.pattern.tacks[0].ends[1].point.y, 0.03);
    use<ActionRow>(hand, tack, QStringLiteral("remove"));
    QVERIFY(hand.document.pattern.tacks.empty());
}

TOILE_TEST(tst_DetailTools, QApplication)
#include "tst_DetailTools.moc"
