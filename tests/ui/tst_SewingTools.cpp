// SPDX-License-Identifier: GPL-3.0-or-later
#include "UiFixtures.h"
#include "core/pattern/PatternMeasures.h"
#include "tests/Suite.h"
#include "ui/panels/PropertySheet.h"
#include "ui/tools/EditSewing.h"
#include "ui/tools/PaintRegion.h"
#include "ui/tools/SewFree.h"
#include "ui/tools/SewSegments.h"

#include <QTest>

using namespace toile;
using namespace toile::ui;

class tst_SewingTools : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void twoClicksSewTwoEdges();
    void pickedEndsMeet_data();
    void pickedEndsMeet();
    void directionAndLengthsAreShownBeforeTheSecondClick();
    void clickOnTheSeamJustMadeReversesIt();
    void sewnEdgesAreRefused();
    void escapeDropsTheFirstPick();
    void edgesInARowAreOneSide();
    void aRowGoesOnOverASeam();
    void aSingleEdgePickedInItsMiddleIsSewnRightSideToRightSide();
    void backspaceTakesTheLastPickBack();
    void anEdgeIsPickedOnce();
    void freeSewingSewsTheStretches();
    void freeSewingSnapsToEnds();
    void aSideMayNotLeaveItsEdge();
    void seamsAreSelectedReversedAndDeleted();
    void theSheetGathersTheLongerSide();
    void theSheetSewsAnElasticIn();
    void theSheetMendsSectionsThatDoNotFit();

    void cornersMakeARegion();
    void aStrokeMakesARegion();
    void aSecondStrokeGrowsTheRegionItTouches();
    void anotherRefinementIsAnotherRegion();
    void altTakesAway();
    void controlWheelChangesTheBrush();
    void paintingBesidePiecesIsRefused();
    void aCancelledToolHasNoSeamJustMade();
};

namespace {

/// Where the parts of a seam begin on the table.
std::array<Vec2, 2> beginnings(const Hand& hand, const pattern::Seam& seam) {
    const FlatPattern flat = flattened(hand.document.pattern);
    return {pathOf(flat, seam.sides[0].front()).front(), pathOf(flat, seam.sides[1].front()).front()};
}

/// The ends of both sides that meet where side one is lowest.
double levelThatMeetsTheBottomOfSideOne(const Hand& hand) {
    const FlatPattern flat = flattened(hand.document.pattern);
    const pattern::Seam& seam = hand.document.pattern.seams.back();
    const auto a = pathOf(flat, seam.sides[0].front()), b = pathOf(flat, seam.sides[1].front());
    return a.front().y < a.back().y ? b.front().y : b.back().y;
}

/// None if the sheet of the seam has no such row.
std::optional<decltype(PropertyRow::content)> rowOfSeam(const document::Document& document, const pattern::SeamId& seam,
                                                        const char* name) {
    const FlatPattern flat = flattened(document.pattern);
    const PropertySheet sheet = sheetOf({document, flat, {seam}}, {});
    const auto row = std::ranges::find(sheet.rows, QString::fromLatin1(name), &PropertyRow::name);
    return row == sheet.rows.end() ? std::nullopt : std::optional(row->content);
}

} // namespace

void tst_SewingTools::twoClicksSewTwoEdges() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.click(tool, {0.2, -0.1});
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
    const pattern::Seam& seam = hand.document.pattern.seams[0];
    QCOMPARE(QString::fromStdString(seam.name), QStringLiteral("Front – Back"));
    QVERIFY(hand.selection == Selection{seam.id});
    QVERIFY(hand.message.contains(QStringLiteral("300.0 mm")));
}

void tst_SewingTools::pickedEndsMeet_data() {
    QTest::addColumn<double>("first");
    QTest::addColumn<double>("second");
    QTest::addColumn<double>("meets");
    QTest::newRow("bottom to bottom") << -0.12 << -0.12 << -0.15;
    QTest::newRow("bottom to top") << -0.12 << 0.12 << 0.15;
    QTest::newRow("top to top") << 0.12 << 0.12 << -0.15;
    QTest::newRow("top to bottom") << 0.12 << -0.12 << 0.15;
}

void tst_SewingTools::pickedEndsMeet() {
    QFETCH(double, first);
    QFETCH(double, second);
    QFETCH(double, meets);
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, first});
    hand.click(tool, {0.2, second});
    QCOMPARE(levelThatMeetsTheBottomOfSideOne(hand), meets);
}

void tst_SewingTools::directionAndLengthsAreShownBeforeTheSecondClick() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.move(tool, {0.2, -0.1});
    const Overlay overlay = hand.overlay(tool);
    QVERIFY(overlay.arrows.size() >= 2);
    QCOMPARE(overlay.labels.size(), std::size_t(1));
    QVERIFY(overlay.labels[0].text.contains(QStringLiteral("difference 0.0 mm")));
    QVERIFY(hand.document.pattern.seams.empty());
}

void tst_SewingTools::clickOnTheSeamJustMadeReversesIt() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.click(tool, {0.2, -0.1});
    const auto before = beginnings(hand, hand.document.pattern.seams[0]);
    hand.click(tool, {0.2, 0.05});
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
    const auto after = beginnings(hand, hand.document.pattern.seams[0]);
    QVERIFY((before[0] == after[0]) != (before[1] == after[1])); // one of the sides begins at its other end now
}

void tst_SewingTools::sewnEdgesAreRefused() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.click(tool, {0.2, -0.1});
    SewSegments another;
    hand.press(another, {0.1, -0.1});
    QVERIFY(hand.refused);
    QVERIFY(hand.message.contains(QStringLiteral("Front – Back")));
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
}

void tst_SewingTools::escapeDropsTheFirstPick() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.key(tool, ToolKey::escape);
    hand.click(tool, {0.2, -0.1});
    QVERIFY(hand.document.pattern.seams.empty());
}

void tst_SewingTools::edgesInARowAreOneSide() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {-0.02, -0.15}, shift); // the hem of the front, picked nearer to its left end …
    hand.click(tool, {0.1, 0.1});            // … goes on up its right side: so it is walked to the right
    QVERIFY(hand.overlay(tool).arrows.size() >= 6);
    hand.click(tool, {0.2, -0.1}, shift);
    hand.key(tool, ToolKey::enter); // the other side is the back's left edge alone
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
    const pattern::Seam& seam = hand.document.pattern.seams[0];
    QCOMPARE(seam.sides[0].size(), std::size_t(2));
    QCOMPARE(seam.sides[1].size(), std::size_t(1));
    const FlatPattern flat = flattened(hand.document.pattern);
    const auto a = pathsOf(flat, seam.sides[0]), b = pathsOf(flat, seam.sides[1]);
    QVERIFY(distance(a[0].front(), {-0.1, -0.15}) < 1e-9);
    QVERIFY(distance(a[0].back(), a[1].front()) < 1e-9); // no jump within the side
    QVERIFY(distance(a[1].back(), {0.1, 0.15}) < 1e-9);
    QVERIFY(distance(b[0].front(), {0.2, -0.15}) < 1e-9); // picked near its bottom: it meets the beginning
    QVERIFY(hand.message.contains(QStringLiteral("500.0 mm to 300.0 mm")));
}

void tst_SewingTools::aRowGoesOnOverASeam() {
    SewSegments tool;
    Hand hand{withRectangle(twoRectangles(), "Band", {0.15, 0.4}, 0.4, 0.05)};
    hand.click(tool, {0.1, 0.1}); // the side seam: top to top
    hand.click(tool, {0.2, 0.1});
    hand.click(tool, {-0.02, 0.15}, shift); // the waist of the front, then of the back: left to right
    hand.click(tool, {0.37, 0.15});         // picked at its far end, but it goes on at the side seam
    hand.click(tool, {0.0, 0.375});
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(2));
    const FlatPattern flat = flattened(hand.document.pattern);
    const auto waist = pathsOf(flat, hand.document.pattern.seams[1].sides[0]);
    QCOMPARE(waist.size(), std::size_t(2));
    QVERIFY(distance(waist[0].back(), {0.1, 0.15}) < 1e-9);
    QVERIFY(distance(waist[1].front(), {0.2, 0.15}) < 1e-9);
}

void tst_SewingTools::aSingleEdgePickedInItsMiddleIsSewnRightSideToRightSide() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.08, -0.15}, shift);
    hand.click(tool, {0.1, 0.1});
    hand.click(tool, {0.2, 0.0});
    const FlatPattern flat = flattened(hand.document.pattern);
    const auto b = pathsOf(flat, hand.document.pattern.seams[0].sides[1]);
    QVERIFY(distance(b[0].front(), {0.2, -0.15}) < 1e-9); // side one runs with its contour: this one against its own
}

void tst_SewingTools::backspaceTakesTheLastPickBack() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});        // side one
    hand.click(tool, {0.2, -0.1}, shift); // side two …
    hand.key(tool, ToolKey::backspace);
    hand.key(tool, ToolKey::backspace); // … and side one are taken back
    hand.click(tool, {0.2, -0.1});      // side one again
    QVERIFY(hand.document.pattern.seams.empty());
    hand.click(tool, {0.1, -0.1});
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
    QCOMPARE(hand.document.pattern.seams[0].sides[0].front().piece, hand.piece(1).id);
}

void tst_SewingTools::anEdgeIsPickedOnce() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1}, shift);
    hand.click(tool, {0, 0.15}, shift);
    hand.press(tool, {0.1, 0.1}, shift);
    QVERIFY(hand.refused);
}

void tst_SewingTools::freeSewingSewsTheStretches() {
    SewFree tool;
    Hand hand{twoRectangles()};
    for (const Vec2 at : {Vec2{0.1, -0.1}, {0.1, 0.05}, {0.2, -0.05}, {0.2, 0.1}}) hand.click(tool, at);
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
    const FlatPattern flat = flattened(hand.document.pattern);
    const pattern::Seam& seam = hand.document.pattern.seams[0];
    QVERIFY(std::abs(lengthOf(pathOf(flat, seam.sides[0].front())) - 0.15) < 1e-6); // search along the edge
    const auto begin = beginnings(hand, seam);
    const bool low = begin[0].y < 0 && begin[1].y < 0;
    const bool high = begin[0].y > 0 && begin[1].y > 0;
    QVERIFY(low || high); // beginnings meet, whichever way the seam is walked
}

void tst_SewingTools::freeSewingSnapsToEnds() {
    SewFree tool;
    Hand hand{twoRectangles()};
    for (const Vec2 at : {Vec2{0.1, -0.148}, {0.1, 0}, {0.2, -0.148}, {0.2, 0}}) hand.click(tool, at);
    QCOMPARE(hand.document.pattern.seams.size(), std::size_t(1));
    QCOMPARE(hand.document.pattern.seams[0].sides[0].front().from, 0.0);
}

void tst_SewingTools::aSideMayNotLeaveItsEdge() {
    SewFree tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.press(tool, {0.2, 0.1});
    QVERIFY(hand.refused);
}

void tst_SewingTools::seamsAreSelectedReversedAndDeleted() {
    SewSegments sew;
    EditSewing tool;
    Hand hand{twoRectangles()};
    hand.click(sew, {0.1, -0.1});
    hand.click(sew, {0.2, -0.1});
    hand.selection = {};
    hand.doubleClick(tool, {0.2, 0.02});
    QVERIFY(hand.selection == Selection{hand.document.pattern.seams[0].id});
    QCOMPARE(levelThatMeetsTheBottomOfSideOne(hand), 0.15);
    hand.key(tool, ToolKey::erase);
    QVERIFY(hand.document.pattern.seams.empty());
}

void tst_SewingTools::theSheetMendsSectionsThatDoNotFit() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.click(tool, {0.2, -0.1});
    pattern::Pattern& pattern = hand.document.pattern;
    pattern.seams.at(0).sections = {{0.01, {}}, {}}; // as a file may have them: there are no notches
    QVERIFY(!sectionsOf(pattern, pattern.seams[0]));
    hand.feed([&](const Desk& desk) {
        const PropertySheet sheet = seamSheet(desk, pattern.seams[0]);
        const auto row = std::ranges::find(sheet.rows, QStringLiteral("easeAway"), &PropertyRow::name);
        return row == sheet.rows.end() ? Effect{}
                                       : effectOf(row->label, std::get<ActionRow>(row->content), desk.document);
    });
    QVERIFY(sectionsOf(pattern, pattern.seams[0]));
}

void tst_SewingTools::theSheetGathersTheLongerSide() {
    SewSegments tool;
    Hand hand{withRectangle(withRectangle({}, "Skirt", {0, 0}, 0.2, 0.45), "Band", {0.3, 0}, 0.2, 0.3)};
    hand.click(tool, {0.1, -0.1});
    hand.click(tool, {0.2, -0.1});
    const auto seam = [&]() -> const pattern::Seam& { return hand.document.pattern.seams.at(0); };
    const auto rowOf = [&](const char* name) { return rowOfSeam(hand.document, seam().id, name); };
    QVERIFY(rowOf("ease") && !rowOf("gatherRatio"));
    hand.document = *std::get<FlagRow>(*rowOf("gathered")).set(hand.document, true);
    QVERIFY(std::abs(*seam().sections.at(0).gatherRatio - 1.5) < 1e-12);
    QVERIFY(!rowOf("ease"));
    const NumberRow ratio = std::get<NumberRow>(*rowOf("gatherRatio"));
    QVERIFY(std::abs(ratio.value - 1.5) < 1e-12);
    hand.document = *ratio.set(hand.document, 1.6);
    QCOMPARE(*seam().sections.at(0).gatherRatio, 1.6);
    hand.document = *std::get<FlagRow>(*rowOf("gathered")).set(hand.document, false);
    QVERIFY(!seam().sections.at(0).gatherRatio);
    QVERIFY(std::abs(seam().sections.at(0).ease - 0.15) < 1e-12);
}

void tst_SewingTools::theSheetSewsAnElasticIn() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.click(tool, {0.2, -0.1});
    const auto seam = [&]() -> const pattern::Seam& { return hand.document.pattern.seams.at(0); };
    const auto rowOf = [&](const char* name) { return rowOfSeam(hand.document, seam().id, name); };
    QVERIFY(rowOf("elastic") && !rowOf("elasticRatio"));
    hand.document = *std::get<FlagRow>(*rowOf("elastic")).set(hand.document, true);
    QVERIFY(seam().elastic == pattern::Elastic{});
    hand.document = *std::get<NumberRow>(*rowOf("elasticRatio")).set(hand.document, 0.6);
    hand.document = *std::get<NumberRow>(*rowOf("elasticStiffness")).set(hand.document, 25);
    QVERIFY(seam().elastic == (pattern::Elastic{.ratio = 0.6, .stiffness = 25}));
    hand.document = *std::get<FlagRow>(*rowOf("elastic")).set(hand.document, false);
    QVERIFY(!seam().elastic && !rowOf("elasticStiffness"));
}

void tst_SewingTools::cornersMakeARegion() {
    PaintOptions options{.refinement = 2};
    PaintPolygon tool(options);
    Hand hand{twoRectangles()};
    for (const Vec2 at : {Vec2{0.25, -0.05}, {0.35, -0.05}, {0.35, 0.05}, {0.25, 0.05}, {0.25, -0.05}})
        hand.click(tool, at);
    QCOMPARE(hand.piece(1).regions.size(), std::size_t(1));
    const pattern::Region& region = hand.piece(1).regions[0];
    QCOMPARE(region.refinement, 2);
    QVERIFY(std::abs(geometry::signedArea(region.outline) - 0.01) < 1e-12);
    QVERIFY(hand.selection == (Selection{RegionRef{hand.piece(1).id, region.id}}));
}

void tst_SewingTools::aStrokeMakesARegion() {
    PaintOptions options{.refinement = 1, .radius = 0.02};
    PaintBrush tool(options);
    Hand hand{twoRectangles()};
    hand.drag(tool, {-0.05, 0}, {0.05, 0});
    QCOMPARE(hand.piece(0).regions.size(), std::size_t(1));
    const double area = geometry::signedArea(hand.piece(0).regions[0].outline);
    const double exact = 0.1 * 0.04 + 3.14159265 * 0.02 * 0.02; // a stadium
    QVERIFY(std::abs(area - exact) < 0.04 * exact);             // its border is within radius/50
}

void tst_SewingTools::aSecondStrokeGrowsTheRegionItTouches() {
    PaintOptions options{.refinement = 1, .radius = 0.02};
    PaintBrush tool(options);
    Hand hand{twoRectangles()};
    hand.drag(tool, {-0.05, 0}, {0.05, 0});
    const double before = geometry::signedArea(hand.piece(0).regions[0].outline);
    hand.drag(tool, {0, 0}, {0, 0.08});
    QCOMPARE(hand.piece(0).regions.size(), std::size_t(1));
    QVERIFY(geometry::signedArea(hand.piece(0).regions[0].outline) > before * 1.2);
}

void tst_SewingTools::anotherRefinementIsAnotherRegion() {
    PaintOptions options{.refinement = 1, .radius = 0.02};
    PaintBrush tool(options);
    Hand hand{twoRectangles()};
    hand.drag(tool, {-0.05, 0}, {0.05, 0});
    options.refinement = 2;
    hand.drag(tool, {-0.05, 0.1}, {0.05, 0.1});
    QCOMPARE(hand.piece(0).regions.size(), std::size_t(2));
    QCOMPARE(hand.piece(0).regions[1].refinement, 2);
}

void tst_SewingTools::altTakesAway() {
    PaintOptions options{.refinement = 1, .radius = 0.02};
    PaintBrush tool(options);
    Hand hand{twoRectangles()};
    hand.drag(tool, {-0.05, 0}, {0.05, 0});
    const double before = geometry::signedArea(hand.piece(0).regions[0].outline);
    options.radius = 0.01;
    hand.drag(tool, {0.06, 0}, {0.04, 0}, {.alt = true});
    QVERIFY(geometry::signedArea(hand.piece(0).regions[0].outline) < before);
}

void tst_SewingTools::controlWheelChangesTheBrush() {
    PaintOptions options;
    PaintBrush tool(options);
    const double before = options.radius;
    QVERIFY(tool.wheel(1));
    QVERIFY(options.radius > before);
}

void tst_SewingTools::paintingBesidePiecesIsRefused() {
    PaintOptions options;
    PaintBrush tool(options);
    Hand hand{twoRectangles()};
    hand.press(tool, {1, 1});
    QVERIFY(hand.refused);
}

void tst_SewingTools::aCancelledToolHasNoSeamJustMade() {
    SewSegments tool;
    Hand hand{twoRectangles()};
    hand.click(tool, {0.1, -0.1});
    hand.click(tool, {0.2, -0.1});
    hand.key(tool, ToolKey::escape); // drops picks, of which there are none
    hand.press(tool, {0.2, 0.05});
    QVERIFY(!hand.refused);
    tool.cancel();
    Hand another{hand.document}; // its seam has the same id
    another.press(tool, {0.2, 0.05});
    QVERIFY(another.refused);
    QVERIFY(another.document == hand.document);
}

TOILE_TEST(tst_SewingTools)
#include "tst_SewingTools.moc"
