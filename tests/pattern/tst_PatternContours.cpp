// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternContours.h"
#include "tests/Suite.h"

#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternSeams.h"
#include "tests/pattern/ErrorsOf.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>
#include <algorithm>
#include <numbers>

using namespace toile;
using namespace toile::pattern;
using tests::back;
using tests::front;

class tst_PatternContours : public QObject {
    Q_OBJECT
private slots:
    void anEditLeavesThePatternItWasGiven();
    void piecesThatWereNotTouchedAreShared();
    void aContourRunsCounterClockwiseHoweverItWasDrawn();
    void aContourWithoutAreaIsRefused();
    void handlesGoWithTheirVertex();
    void anEditOfAMirrorImageIsRefused();
    void aSplitEdgeKeepsItsCourse_data();
    void aSplitEdgeKeepsItsCourse();
    void aSplitEdgeKeepsItsSeamsWhereTheyWere_data();
    void aSplitEdgeKeepsItsSeamsWhereTheyWere();
    void aSplitEdgeKeepsItsNotchesWhereTheyWere();
    void deletingAnInsertedVertexGivesBackThePattern_data();
    void deletingAnInsertedVertexGivesBackThePattern();
    void deletingTheFirstVertexJoinsTheEdgesAroundIt();
    void deletingACornerWarnsOfItsSeams();
    void deletingADoubledPointKeepsItsSeams_data();
    void deletingADoubledPointKeepsItsSeams();
    void aSeamAlongNoLengthGoesWithTheDoubledPoint();
    void threePointsOnOneAreJoinedToTwo();
    void joinedEdgesOfDifferentAllowancesAreNamed();
    void threePointsCannotBecomeTwo();
    void aLineBecomesACurveByItsHandle();
    void theCubicOfAnArcMeetsItsMiddle();
    void aHoleRunsClockwise();
    void aDeletedHoleTakesItsSeamsAlong();
    void anEdgeHasASeamAllowanceOfItsOwn();
    void sectionsThatLoseTheirNotchesAreAddedUp();
    void aDividedSectionIsSharedByLength();
    void aNotchThatMovesToTheEndOfItsSeamEndsASection();
    void easeOfAWholeSeamStaysWhenItIsNotched();
};

namespace {

constexpr double rounding = 1e-12; // [m]

std::vector<Vec2> seamPoints(const Pattern& pattern, const Seam& seam, std::size_t side) {
    std::vector<Vec2> points;
    for (const SeamPart& part : seam.sides[side])
        for (const Vec2 p : partPoints(pattern, part, 1e-6)) points.push_back(p);
    return points;
}

/// The back's corner v3 is two points on one another, 2 and 3 of its outline; the edge between them is without length.
Pattern withDoubledCorner() {
    IdSource ids{60};
    Pattern pattern = *insertVertex(tests::twoPanels(), back, EdgeId("top"), 0.5, ids);
    return *moveVertex(pattern, back, pattern.pieces[1]->outline.vertices[3].id, {0.3, 0.4});
}

/// Three sections along the right side.
Pattern withNotchesOnBothSides() {
    Pattern pattern = *addNotch(tests::twoPanels(), back, {EdgeId("left"), 0.25});
    return *addNotch(pattern, back, {EdgeId("left"), 0.75});
}

Pattern withEdgeShape(const EdgeShape& shape) {
    return *setEdgeShape(tests::twoPanels(), front, EdgeId("right"), shape);
}

void addShapes() {
    QTest::addColumn<int>("shape");
    QTest::addColumn<double>("fraction");
    const char* names[] = {"line", "cubic", "arc"};
    for (int shape = 0; shape < 3; ++shape)
        for (const double fraction : {0.1, 0.5, 0.8})
            QTest::addRow("a %s at %g", names[shape], fraction) << shape << fraction;
}

EdgeShape shapeNumber(int n) {
    if (n == 0) return geometry::LineShape{};
    if (n == 1) return geometry::CubicShape{{0.33, 0.1}, {0.28, 0.3}};
    return geometry::ArcShape{0.4};
}

} // namespace

void tst_PatternContours::anEditLeavesThePatternItWasGiven() {
    const Pattern before = tests::twoPanels(), copy = before;
    QVERIFY(moveVertex(before, front, VertexId("v1"), {-0.1, 0}));
    QVERIFY(before == copy);
}

void tst_PatternContours::piecesThatWereNotTouchedAreShared() {
    const Pattern before = tests::twoPanels();
    const Pattern after = *moveVertex(before, front, VertexId("v1"), {-0.1, 0});
    QVERIFY(!after.pieces[0].sameAs(before.pieces[0]));
    QVERIFY(after.pieces[1].sameAs(before.pieces[1]));
}

void tst_PatternContours::aContourRunsCounterClockwiseHoweverItWasDrawn() {
    const std::vector<Vec2> clockwise{{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    const std::vector<EdgeShape> shapes{geometry::ArcShape{0.2}}; // the edge from (0,0) to (0,1)
    IdSource ids;
    const auto contour = contourThrough(clockwise, shapes, ids);
    QVERIFY(contour);
    QVERIFY(geometry::signedArea(flattened(*contour, 1e-4)) > 0);
    QCOMPARE(contour->vertices[0].position, (Vec2{0, 0})); // begins where it was begun
    // The arc turned left on its way up; walked down it turns right, between the same points.
    QCOMPARE(std::get<geometry::ArcShape>(contour->edges[3].shape).bulge, -0.2);
}

void tst_PatternContours::aContourWithoutAreaIsRefused() {
    IdSource ids;
    QVERIFY(!contourThrough(std::vector<Vec2>{{0, 0}, {1, 0}}, {}, ids));
    QVERIFY(!contourThrough(std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}}, {}, ids));
    QVERIFY(!contourThrough(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 0}, {0, 1}}, {}, ids));
    QVERIFY(!contourThrough(std::vector<Vec2>{{0, 0}, {1, 0}, {0, std::nan("")}}, {}, ids));
}

void tst_PatternContours::handlesGoWithTheirVertex() {
    const Pattern after = *moveVertex(tests::twoPanels(), front, VertexId("v3"), {0.32, 0.45}); // by (0.02, 0.05)
    const auto cubic = std::get<geometry::CubicShape>(after.pieces[0]->outline.edges[1].shape);
    QCOMPARE(cubic.control1, (Vec2{0.33, 0.1}));
    QVERIFY(geometry::distance(cubic.control2, Vec2{0.30, 0.35}) < rounding);
    QCOMPARE(after.pieces[0]->outline.vertices[2].position, (Vec2{0.32, 0.45}));
}

void tst_PatternContours::anEditOfAMirrorImageIsRefused() {
    const auto edited = moveVertex(tests::twoPanels(), PieceId("image"), VertexId("v1"), {0, 0});
    QVERIFY(!edited);
    QCOMPARE(edited.error().place.object, std::string("piece \"image\""));
}

void tst_PatternContours::aSplitEdgeKeepsItsCourse_data() {
    addShapes();
}

void tst_PatternContours::aSplitEdgeKeepsItsCourse() {
    QFETCH(int, shape);
    QFETCH(double, fraction);
    const Pattern before = withEdgeShape(shapeNumber(shape));
    IdSource ids{50};
    const Pattern after = *insertVertex(before, front, EdgeId("right"), fraction, ids);
    QCOMPARE(after.pieces[0]->outline.vertices.size(), std::size_t(5));
    const geometry::ArcLength whole(curveOf(before.pieces[0]->outline, 1));
    const geometry::ArcLength first(curveOf(after.pieces[0]->outline, 1)), second(curveOf(after.pieces[0]->outline, 2));
    QVERIFY(std::abs(first.total() - fraction * whole.total()) < 1e-11); // arc lengths are good to 1e-12 of the length
    for (int i = 0; i <= 10; ++i) {
        const double f = 0.1 * i;
        QVERIFY(geometry::distance(first.pointAt(f), whole.pointAt(f * fraction)) < 1e-11);
        QVERIFY(geometry::distance(second.pointAt(f), whole.pointAt(fraction + f * (1 - fraction))) < 1e-11);
    }
}

void tst_PatternContours::aSplitEdgeKeepsItsSeamsWhereTheyWere_data() {
    QTest::addColumn<QString>("piece");
    QTest::addColumn<QString>("edge");
    QTest::newRow("a side walked forwards") << "front"
                                            << "right";
    QTest::newRow("a side walked backwards") << "back"
                                             << "left";
}

void tst_PatternContours::aSplitEdgeKeepsItsSeamsWhereTheyWere() {
    QFETCH(QString, piece);
    QFETCH(QString, edge);
    Pattern before = tests::twoPanels();
    before.seams[0].sides[0][0].from = 0.2; // a stretch that does not fill its edge
    before.seams[0].sides[1][0].to = 0.9;
    before.seams.push_back(
        {SeamId("s3"),
         "image",
         {{{{PieceId("image"), EdgeId("right"), 0.3, 0.7, true}}, {{PieceId("back"), EdgeId("top"), 0, 1, false}}}}});
    IdSource ids{50};
    const Pattern after = *insertVertex(before, PieceId(piece.toStdString()), EdgeId(edge.toStdString()), 0.45, ids);
    for (std::size_t s = 0; s < before.seams.size(); ++s)
        for (std::size_t side = 0; side < 2; ++side) {
            const auto was = seamPoints(before, before.seams[s], side), is = seamPoints(after, after.seams[s], side);
            QVERIFY(geometry::distance(was.front(), is.front()) < 1e-11);
            QVERIFY(geometry::distance(was.back(), is.back()) < 1e-11);
            double lengthBefore = 0, lengthAfter = 0;
            for (const SeamPart& part : before.seams[s].sides[side]) lengthBefore += *partLength(before, part);
            for (const SeamPart& part : after.seams[s].sides[side]) lengthAfter += *partLength(after, part);
            QVERIFY(std::abs(lengthBefore - lengthAfter) < 1e-11);
            const auto& parts = after.seams[s].sides[side];
            for (std::size_t i = 1; i < parts.size(); ++i) // no jumps
                QVERIFY(geometry::distance(partPoints(after, parts[i - 1], 1e-6).back(),
                                           partPoints(after, parts[i], 1e-6).front()) < 1e-11);
        }
}

void tst_PatternContours::aSplitEdgeKeepsItsNotchesWhereTheyWere() {
    const Pattern before = tests::twoPanels();
    IdSource ids{50};
    const Pattern after = *insertVertex(before, front, EdgeId("right"), 0.5, ids);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto place = [&](const Pattern& p) {
            const Notch& notch = p.pieces[0]->notches[i];
            return geometry::ArcLength(curveOf(*p.pieces[0], *findEdge(*p.pieces[0], notch.edge)))
                .pointAt(notch.position);
        };
        QVERIFY(geometry::distance(place(before), place(after)) < 1e-11);
    }
    QVERIFY(after.pieces[0]->notches[1].edge != EdgeId("right"));
}

void tst_PatternContours::deletingAnInsertedVertexGivesBackThePattern_data() {
    addShapes();
}

void tst_PatternContours::deletingAnInsertedVertexGivesBackThePattern() {
    QFETCH(int, shape);
    QFETCH(double, fraction);
    const Pattern before = withEdgeShape(shapeNumber(shape));
    IdSource ids{50};
    const Pattern split = *insertVertex(before, front, EdgeId("right"), fraction, ids);
    const auto joined = deleteVertex(split, front, split.pieces[0]->outline.vertices[2].id);
    QVERIFY(joined);
    QCOMPARE(joined->warnings.size(), std::size_t(0));
    const Pattern& after = joined->pattern;
    QCOMPARE(after.pieces[0]->outline.edges[1].id, EdgeId("right"));
    QCOMPARE(after.pieces[0]->outline.edges[1].shape.index(), before.pieces[0]->outline.edges[1].shape.index());
    const geometry::ArcLength was(curveOf(before.pieces[0]->outline, 1)), is(curveOf(after.pieces[0]->outline, 1));
    for (int i = 0; i <= 10; ++i) QVERIFY(geometry::distance(was.pointAt(0.1 * i), is.pointAt(0.1 * i)) < 1e-9);
    QCOMPARE(after.seams[0].sides[0].size(), std::size_t(1));
    QVERIFY(after.seams[0].sides == before.seams[0].sides);
    for (std::size_t i = 0; i < 2; ++i)
        QVERIFY(std::abs(after.pieces[0]->notches[i].position - before.pieces[0]->notches[i].position) < 1e-9);
}

void tst_PatternContours::deletingTheFirstVertexJoinsTheEdgesAroundIt() {
    const auto edited = deleteVertex(tests::twoPanels(), front, VertexId("v1"));
    QVERIFY(edited);
    const Contour& contour = edited->pattern.pieces[0]->outline;
    QCOMPARE(contour.vertices.size(), std::size_t(3));
    QCOMPARE(contour.edges.back().id, EdgeId("left"));
    QCOMPARE(curveOf(contour, 2).start, (Vec2{0, 0.4}));
    QCOMPARE(curveOf(contour, 2).end, (Vec2{0.3, 0}));
}

void tst_PatternContours::deletingACornerWarnsOfItsSeams() {
    const auto edited = deleteVertex(tests::twoPanels(), front, VertexId("v3"));
    QVERIFY(edited);
    QCOMPARE(edited->warnings.size(), std::size_t(2)); // the seam along the right edge, and the pin
    QCOMPARE(edited->warnings[0].place, std::string("seam \"right side\""));
    QVERIFY(edited->pattern.pins.empty());
}

void tst_PatternContours::deletingADoubledPointKeepsItsSeams_data() {
    QTest::addColumn<std::size_t>("deleted");
    QTest::newRow("the first of the two") << std::size_t(2);
    QTest::newRow("the second of the two") << std::size_t(3);
}

void tst_PatternContours::deletingADoubledPointKeepsItsSeams() {
    QFETCH(std::size_t, deleted);
    const Pattern doubled = withDoubledCorner();
    const Contour& contour = doubled.pieces[1]->outline;
    Pattern pattern = doubled; // the edge between the two points is sewn with the edge before it
    pattern.seams[1].sides[1].insert(pattern.seams[1].sides[1].begin(), {back, contour.edges[2].id, 0, 1, true});
    const auto edited = deleteVertex(pattern, back, contour.vertices[deleted].id);
    QVERIFY(edited && tests::errorsOf(edited->pattern).empty());
    QCOMPARE(edited->pattern.seams.size(), pattern.seams.size());
    const auto& side = edited->pattern.seams[1].sides[1];
    QCOMPARE(side.size(), std::size_t(1));
    QVERIFY(side[0].from == 0 && side[0].to == 1);
}

void tst_PatternContours::aSeamAlongNoLengthGoesWithTheDoubledPoint() {
    Pattern pattern = withDoubledCorner();
    const Contour& contour = pattern.pieces[1]->outline;
    pattern.seams = {{SeamId("s3"), "nothing", {{{{back, contour.edges[2].id}}, {{front, EdgeId("bottom")}}}}}};
    for (const std::size_t deleted : {std::size_t(2), std::size_t(3)}) {
        const auto edited = deleteVertex(pattern, back, contour.vertices[deleted].id);
        QVERIFY(edited && edited->pattern.seams.empty());
        QCOMPARE(edited->warnings.back().place, std::string("seam \"nothing\""));
    }
}

void tst_PatternContours::threePointsOnOneAreJoinedToTwo() {
    for (const EdgeShape& shape :
         {EdgeShape{geometry::LineShape{}}, EdgeShape{geometry::CubicShape{{0.3, 0.4}, {0.3, 0.4}}}}) {
        IdSource ids{70};
        Pattern pattern = withDoubledCorner();
        pattern = *insertVertex(pattern, back, pattern.pieces[1]->outline.edges[2].id, 0.5, ids);
        for (const std::size_t edge : {std::size_t(2), std::size_t(3)})
            pattern = *setEdgeShape(pattern, back, pattern.pieces[1]->outline.edges[edge].id, shape);
        const auto edited = deleteVertex(pattern, back, pattern.pieces[1]->outline.vertices[3].id);
        QVERIFY(edited);
        const Contour& joined = edited->pattern.pieces[1]->outline;
        QVERIFY(geometry::distance(geometry::pointAt(curveOf(joined, 2), 0.3), {0.3, 0.4}) < 1e-15);
    }
}

void tst_PatternContours::joinedEdgesOfDifferentAllowancesAreNamed() {
    const Pattern wide = *setEdgeSeamAllowance(tests::twoPanels(), front, EdgeId("top"), 0.03);
    IdSource ids{50};
    const Pattern split = *insertVertex(wide, front, EdgeId("top"), 0.5, ids); // both halves have it
    const auto joined = deleteVertex(split, front, split.pieces[0]->outline.vertices[3].id);
    QVERIFY(joined && joined->warnings.empty());
    const auto edited = deleteVertex(wide, front, VertexId("v4"));
    QVERIFY(edited);
    QVERIFY(std::ranges::any_of(edited->warnings, [](const Warning& warning) {
        return warning.place == "piece \"front\"" &&
               warning.text.find("seam allowances of 30.0 and 10.0 mm") != std::string::npos;
    }));
}

void tst_PatternContours::threePointsCannotBecomeTwo() {
    const auto three = deleteVertex(tests::twoPanels(), front, VertexId("v1"));
    QVERIFY(!deleteVertex(three->pattern, front, VertexId("v2")));
}

void tst_PatternContours::aLineBecomesACurveByItsHandle() {
    const Pattern after = *moveHandle(tests::twoPanels(), front, EdgeId("top"), Handle::first, {0.2, 0.5});
    const auto cubic = std::get<geometry::CubicShape>(after.pieces[0]->outline.edges[2].shape);
    QCOMPARE(cubic.control1, (Vec2{0.2, 0.5}));
    QVERIFY(geometry::distance(cubic.control2, Vec2{0.1, 0.4}) < rounding); // a third of the line
}

void tst_PatternContours::theCubicOfAnArcMeetsItsMiddle() {
    const geometry::Curve arc{{1, 0}, {0, 1}, geometry::ArcShape{std::tan(std::numbers::pi / 8)}};
    const geometry::Curve cubic{arc.start, arc.end, cubicOf(arc)};
    QVERIFY(geometry::distance(geometry::pointAt(arc, 0.5), geometry::pointAt(cubic, 0.5)) < rounding);
    for (int i = 1; i < 20; ++i) // a quarter circle by one cubic: 2.7e-4 of the radius
        QVERIFY(std::abs(geometry::length(geometry::pointAt(cubic, 0.05 * i)) - 1) < 2.8e-4);
}

void tst_PatternContours::aHoleRunsClockwise() {
    IdSource ids{50};
    const std::vector<Vec2> points{{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.1, 0.2}};
    const Pattern after = *addHole(tests::twoPanels(), front, points, ids);
    QVERIFY(geometry::signedArea(flattened(after.pieces[0]->holes[0], 1e-4)) < 0);
    QVERIFY(std::abs(areaOf(*after.pieces[0]) - areaOf(*tests::twoPanels().pieces[0]) + 0.01) < 1e-9);
}

void tst_PatternContours::aDeletedHoleTakesItsSeamsAlong() {
    IdSource ids{50};
    const std::vector<Vec2> points{{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.1, 0.2}};
    Pattern pattern = *addHole(tests::twoPanels(), front, points, ids);
    const EdgeId edge = pattern.pieces[0]->holes[0].edges[0].id;
    pattern.seams.push_back({SeamId("s3"), "pocket", {{{{front, edge}}, {{PieceId("back"), EdgeId("top")}}}}});
    const auto edited = deleteHole(pattern, front, 0);
    QVERIFY(edited);
    QCOMPARE(edited->warnings.size(), std::size_t(1));
    QVERIFY(edited->pattern == tests::twoPanels());
}

void tst_PatternContours::anEdgeHasASeamAllowanceOfItsOwn() {
    const auto after = setEdgeSeamAllowance(tests::twoPanels(), front, EdgeId("top"), 0.03);
    QCOMPARE(*after->pieces[0]->outline.edges[2].seamAllowance, 0.03);
    QVERIFY(!setEdgeSeamAllowance(tests::twoPanels(), front, EdgeId("top"), -0.01));
}

void tst_PatternContours::sectionsThatLoseTheirNotchesAreAddedUp() {
    Pattern eased = withNotchesOnBothSides();
    eased.seams[0].sections = {{0.001, {}}, {0.002, {}}, {0.004, {}}};
    const Pattern one = *removeNotch(eased, front, 0); // two notches meet one: there is nothing to pair
    QCOMPARE(one.seams[0].sections.size(), std::size_t(1));
    QVERIFY(std::abs(one.seams[0].sections[0].ease - 0.007) < rounding);
    const Pattern two = *removeNotch(*addNotch(one, front, eased.pieces[0]->notches[0]), front, 1);
    QVERIFY(two.seams[0].sections == one.seams[0].sections); // one ease, whatever the notches are

    Pattern gathered = eased;
    gathered.seams[0].sections = {{0, 1.5}, {0, 1.5}, {0, 1.5}};
    QCOMPARE(removeNotch(gathered, front, 1)->seams[0].sections, (std::vector<SeamSection>{{0, 1.5}}));
    gathered.seams[0].sections[2] = {}; // then what is wanted in all: half of the first 75 % of side B, which is 0.4 m
    const SeamSection mixed = removeNotch(gathered, front, 1)->seams[0].sections.at(0);
    QVERIFY(mixed.gatherRatio && std::abs(*mixed.gatherRatio - 1.375) < 1e-9);
}

void tst_PatternContours::aDividedSectionIsSharedByLength() {
    Pattern pattern = tests::twoPanels(); // a notch on the front is on its image as well: both sides have it
    pattern.seams = {
        {SeamId("s3"), "centre front", {{{{front, EdgeId("left")}}, {{PieceId("image"), EdgeId("left")}}}}}};
    pattern = *addNotch(pattern, front, {EdgeId("left"), 0.6});
    pattern.seams[0].sections = {{0.003, {}}, {0, 1.2}};
    const Pattern eased = *addNotch(pattern, front, {EdgeId("left"), 0.2}),
                  gathered = *addNotch(pattern, front, {EdgeId("left"), 0.7});
    const auto& shared = eased.seams[0].sections;
    QCOMPARE(shared.size(), std::size_t(3));
    QVERIFY(std::abs(shared[0].ease - 0.001) < rounding && std::abs(shared[1].ease - 0.002) < rounding);
    QVERIFY(shared[2] == pattern.seams[0].sections[1]);
    QVERIFY((gathered.seams[0].sections == std::vector<SeamSection>{{0.003, {}}, {0, 1.2}, {0, 1.2}}));
    QVERIFY(sectionsOf(eased, eased.seams[0]) && sectionsOf(gathered, gathered.seams[0]));
    QVERIFY(removeNotch(gathered, front, 3)->seams[0].sections == pattern.seams[0].sections);
}

void tst_PatternContours::aNotchThatMovesToTheEndOfItsSeamEndsASection() {
    Pattern pattern = withNotchesOnBothSides();
    pattern.seams[0].sections = {{0.001, {}}, {0.002, {}}, {0.004, {}}};
    const Notch first = pattern.pieces[0]->notches[0];
    const Pattern moved = *changeNotch(pattern, front, 0, {first.edge, 0.3, first.kind, first.isDouble});
    QVERIFY(moved.seams[0].sections == pattern.seams[0].sections);
    QCOMPARE(moved.pieces[0]->notches[0].position, 0.3);
    QCOMPARE(changeNotch(pattern, front, 0, {first.edge, 0})->seams[0].sections.size(), std::size_t(1));
    QVERIFY(!changeNotch(pattern, front, 2, first) && !changeNotch(pattern, front, 0, {first.edge, 1.5}));
    QVERIFY(!changeNotch(pattern, front, 0, {EdgeId("none"), 0.5}));
}

void tst_PatternContours::easeOfAWholeSeamStaysWhenItIsNotched() {
    Pattern pattern = tests::twoPanels(); // the front has notches, the back not yet
    const SectionLengths whole = sectionsOf(pattern, pattern.seams[0])->at(0);
    pattern.seams[0].sections = {{whole.a - whole.b, {}}};
    pattern = *addNotch(pattern, back, {EdgeId("left"), 0.25});
    pattern = *addNotch(pattern, back, {EdgeId("left"), 0.75});
    QCOMPARE(sectionCount(pattern, pattern.seams[0]), std::size_t(3));
    QCOMPARE(sectionsOf(pattern, pattern.seams[0])->size(), std::size_t(1));
    QVERIFY(tests::errorsOf(pattern).empty());
    const Pattern more = *setSeamEase(pattern, pattern.seams[0].id, 0, 0.001);
    QCOMPARE(more.seams[0].sections, (std::vector<SeamSection>{{0.001, {}}}));
}

TOILE_TEST(tst_PatternContours)
#include "tst_PatternContours.moc"
