// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternRegions.h"
#include "tests/Suite.h"

#include "core/pattern/Brush.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>
#include <numbers>

using namespace toile;
using namespace toile::pattern;
using tests::front;

class tst_PatternRegions : public QObject {
    Q_OBJECT
private slots:
    void aRegionRunsCounterClockwiseHoweverItWasDrawn();
    void aStrokeCoversWhatADiscSweeps();
    void paintingAddsWhatTheStrokeCovers();
    void aStrokeElsewhereIsRefused();
    void aStrokeRoundLeavesAHole();
    void erasingThroughTheMiddleMakesTwoRegions();
    void erasingEverythingRemovesTheRegion();
    void refinementHasLimits();
    void aMirrorImageCannotBePainted();
};

namespace {

double areaOf(const Region& region) {
    double area = geometry::signedArea(region.outline);
    for (const Polygon& hole : region.holes) area += geometry::signedArea(hole); // clockwise: negative
    return area;
}

Pattern withSquare(IdSource& ids) {
    return *addRegion(tests::twoPanels(), front, {{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.1, 0.2}}, "square", 1, ids);
}

const Region& region(const Pattern& pattern, std::size_t i = 0) {
    return pattern.pieces[0]->regions[i];
}

} // namespace

void tst_PatternRegions::aRegionRunsCounterClockwiseHoweverItWasDrawn() {
    IdSource ids{50};
    const Pattern pattern =
        *addRegion(tests::twoPanels(), front, {{0.1, 0.2}, {0.2, 0.2}, {0.2, 0.1}, {0.1, 0.1}}, "square", 2, ids);
    QVERIFY(std::abs(geometry::signedArea(region(pattern).outline) - 0.01) < 1e-12);
    QCOMPARE(region(pattern).refinement, 2);
    QCOMPARE(region(pattern).id, RegionId("r50"));
}

void tst_PatternRegions::aStrokeCoversWhatADiscSweeps() {
    const std::vector<Vec2> stroke{{0, 0}, {0.1, 0}};
    const auto areas = swept(stroke, 0.02);
    QCOMPARE(areas.size(), std::size_t(1));
    // A rectangle and two half discs; a polygon within radius/50 of a circle misses 4/3 · 2 % of its area.
    const double wanted = 0.1 * 0.04 + std::numbers::pi * 0.02 * 0.02;
    QVERIFY(std::abs(geometry::signedArea(areas[0].outline) - wanted) < 0.027 * std::numbers::pi * 0.02 * 0.02);
    const auto dot = swept(std::vector<Vec2>{{0.1, 0.1}}, 0.02);
    QCOMPARE(dot.size(), std::size_t(1));
    QVERIFY(geometry::windingNumber(dot[0].outline, {0.1, 0.119}) == 1);
}

void tst_PatternRegions::paintingAddsWhatTheStrokeCovers() {
    IdSource ids{50};
    const Stroke stroke{{{0.15, 0.15}, {0.25, 0.15}}, 0.02};
    const Pattern painted = *paintRegion(withSquare(ids), front, RegionId("r50"), stroke);
    const double outside = 0.05 * 0.04 + 0.5 * std::numbers::pi * 0.02 * 0.02;
    QVERIFY(std::abs(areaOf(region(painted)) - 0.01 - outside) < 2e-5); // half a disc to 2.7 %
    QCOMPARE(region(painted).name, std::string("square"));
    // Painting the same again changes no area.
    QVERIFY(std::abs(areaOf(region(*paintRegion(painted, front, RegionId("r50"), stroke))) - areaOf(region(painted))) <
            1e-9);
}

void tst_PatternRegions::aStrokeElsewhereIsRefused() {
    IdSource ids{50};
    QVERIFY(!paintRegion(withSquare(ids), front, RegionId("r50"), {{{0.28, 0.3}}, 0.01}));
    QVERIFY(!paintRegion(withSquare(ids), front, RegionId("r50"), {{}, 0.01}));
    QVERIFY(!paintRegion(withSquare(ids), front, RegionId("r50"), {{{0.15, 0.15}}, 0}));
}

void tst_PatternRegions::aStrokeRoundLeavesAHole() {
    IdSource ids{50};
    const Stroke round{{{0.05, 0.05}, {0.15, 0.05}, {0.15, 0.15}, {0.05, 0.15}, {0.05, 0.05}}, 0.01};
    const Pattern painted = *paintNewRegion(tests::twoPanels(), front, round, "ring", 1, ids);
    QCOMPARE(region(painted).holes.size(), std::size_t(1));
    QVERIFY(std::abs(geometry::signedArea(region(painted).holes[0]) + 0.08 * 0.08) <
            1e-9); // clockwise, sharp corners inside
}

void tst_PatternRegions::erasingThroughTheMiddleMakesTwoRegions() {
    IdSource ids{50};
    const Pattern erased = *eraseRegion(withSquare(ids), front, RegionId("r50"), {{{0.14, 0}, {0.14, 0.3}}, 0.01}, ids);
    QCOMPARE(erased.pieces[0]->regions.size(), std::size_t(2));
    QVERIFY(std::abs(areaOf(region(erased, 0)) - 0.05 * 0.1) < 1e-9); // the larger part keeps the id
    QCOMPARE(region(erased, 0).id, RegionId("r50"));
    QVERIFY(std::abs(areaOf(region(erased, 1)) - 0.03 * 0.1) < 1e-9);
    QCOMPARE(region(erased, 1).id, RegionId("r51"));
    QCOMPARE(region(erased, 1).refinement, 1);
}

void tst_PatternRegions::erasingEverythingRemovesTheRegion() {
    IdSource ids{50};
    QVERIFY(
        eraseRegion(withSquare(ids), front, RegionId("r50"), {{{0.15, 0.15}}, 0.2}, ids)->pieces[0]->regions.empty());
}

void tst_PatternRegions::refinementHasLimits() {
    IdSource ids{50};
    const Pattern pattern = withSquare(ids);
    QCOMPARE(region(*setRefinement(pattern, front, RegionId("r50"), 3)).refinement, 3);
    QVERIFY(!setRefinement(pattern, front, RegionId("r50"), -1));
    QVERIFY(!setRefinement(pattern, front, RegionId("r50"), 17));
    QVERIFY(!setStiffness(pattern, front, RegionId("r50"), {1, 0, 1}));
}

void tst_PatternRegions::aMirrorImageCannotBePainted() {
    IdSource ids{50};
    QVERIFY(!paintNewRegion(tests::twoPanels(), PieceId("image"), {{{0.1, 0.1}}, 0.01}, "dot", 1, ids));
}

TOILE_TEST(tst_PatternRegions)
#include "tst_PatternRegions.moc"
