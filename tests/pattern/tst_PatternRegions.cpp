// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternRegions.h"
#include "tests/Suite.h"

#include "core/pattern/Brush.h"
#include "tests/pattern/ErrorsOf.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>
#include <numbers>
#include <random>

using namespace toile;
using namespace toile::pattern;
using tests::front;

class tst_PatternRegions : public QObject {
    Q_OBJECT
private slots:
    void aRegionRunsCounterClockwiseHoweverItWasDrawn();
    void aBorderThatCrossesItselfBecomesThatOfWhatItEncloses();
    void whateverIsPaintedHasABorderThatCrossesNothing();
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

void tst_PatternRegions::aBorderThatCrossesItselfBecomesThatOfWhatItEncloses() {
    IdSource ids{50};
    const auto added = [&](Polygon outline) {
        return addRegion(tests::twoPanels(), front, std::move(outline), "", 1, ids);
    };
    const auto eight = added({{0.05, 0.1}, {0.25, 0.3}, {0.25, 0.1}, {0.05, 0.3}});
    QVERIFY(!eight && eight.error().text.find("crosses itself") != std::string::npos);
    Polygon star; // drawn in one go: its middle is enclosed twice
    for (int i = 0; i < 5; ++i) {
        const double angle = i * 0.8 * std::numbers::pi;
        star.push_back({0.15 + 0.1 * std::sin(angle), 0.2 + 0.1 * std::cos(angle)});
    }
    const auto whole = added(star);
    QVERIFY(whole && tests::errorsOf(*whole).empty());
    QCOMPARE(region(*whole).outline.size(), std::size_t(10));
    QVERIFY(region(*whole).holes.empty());
    const double inner = 0.1 / (std::numbers::phi * std::numbers::phi); // radius of the corners between two tips
    QVERIFY(std::abs(areaOf(region(*whole)) - 5 * 0.1 * inner * std::sin(std::numbers::pi / 5)) < 1e-8);
}

void tst_PatternRegions::whateverIsPaintedHasABorderThatCrossesNothing() {
    std::mt19937 random(1);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const auto at = [&] {
        return Vec2{std::round(between(0.02, 0.28) * 200) / 200, std::round(between(0.02, 0.38) * 200) / 200};
    };
    int strokes = 0;
    for (int go = 0; go < 60; ++go) {
        IdSource ids{50};
        Pattern pattern = withSquare(ids);
        for (int i = 0; i < 20 && !pattern.pieces[0]->regions.empty(); ++i) {
            Stroke stroke{{at()}, std::round(between(1, 6)) * 0.005};
            for (auto more = random() % 6; more > 0; --more) stroke.points.push_back(at());
            const RegionId which = region(pattern).id;
            const auto painted = random() % 3 == 0   ? paintNewRegion(pattern, front, stroke, "more", 1, ids)
                                 : random() % 2 == 0 ? paintRegion(pattern, front, which, stroke)
                                                     : eraseRegion(pattern, front, which, stroke, ids);
            if (!painted) continue;
            pattern = *painted;
            ++strokes;
            for (const std::string& error : tests::errorsOf(pattern))
                QVERIFY2(error.find("crosses") == std::string::npos, error.c_str());
        }
    }
    QVERIFY(strokes > 500);
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
