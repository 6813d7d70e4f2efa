// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternDarts.h"
#include "tests/Suite.h"

#include "core/pattern/PatternCheck.h"
#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternSeams.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>

using namespace toile;
using namespace toile::pattern;
using tests::front;

class tst_PatternDarts : public QObject {
    Q_OBJECT
private slots:
    void aWedgeIsCutAndSewnShut();
    void aSeamAlongTheEdgePassesOverTheMouth();
    void mirrorImagesAreSewnToo();
    void aMouthOnACurveHasItsWidth();
    void impossibleDartsAreRefused();
    void aSeamInTheMouthIsNamed();
};

namespace {

constexpr double dartRounding = 1e-9;

/// In the middle of the front's first edge, 20 mm wide, its tip 60 mm inside.
Dart dartOf(const Pattern& pattern) {
    const Piece& piece = *findPiece(pattern, front);
    const geometry::Curve edge = curveOf(piece.outline, 0);
    const Vec2 inward = normalized(geometry::leftOf(edge.end - edge.start));
    return {piece.outline.edges[0].id, 0.5, 0.02, lerp(edge.start, edge.end, 0.5) + inward * 0.06};
}

} // namespace

void tst_PatternDarts::aWedgeIsCutAndSewnShut() {
    IdSource ids{500};
    const Pattern before = tests::unsewnPanels();
    const auto after = addDart(before, front, dartOf(before), "dart", ids);
    QVERIFY(after);
    QVERIFY(std::abs(areaOf(*findPiece(before, front)) - areaOf(*findPiece(*after, front)) - 0.02 * 0.06 / 2) <
            dartRounding);
    QVERIFY(!hasErrors(checkPattern(*after)));
    const Seam& seam = after->seams[0];
    const auto in = partPoints(*after, seam.sides[0].front(), 1e-4),
               out = partPoints(*after, seam.sides[1].front(), 1e-4);
    QVERIFY(distance(in.back(), out.back()) < dartRounding);                    // at the tip
    QVERIFY(std::abs(distance(in.front(), out.front()) - 0.02) < dartRounding); // across the mouth
    QVERIFY(std::abs(*partLength(*after, seam.sides[0].front()) - *partLength(*after, seam.sides[1].front())) <
            dartRounding);
}

void tst_PatternDarts::aSeamAlongTheEdgePassesOverTheMouth() {
    IdSource ids{500};
    Pattern before = tests::unsewnPanels();
    const EdgeId other = findPiece(before, PieceId("back"))->outline.edges[0].id;
    before = *addSeam(before, {front, dartOf(before).edge}, {PieceId("back"), other}, ids);
    const auto length = [](const Pattern& pattern) {
        double sum = 0;
        for (const SeamPart& part : pattern.seams[0].sides[0]) sum += *partLength(pattern, part);
        return sum;
    };
    const auto after = addDart(before, front, dartOf(before), "dart", ids);
    QVERIFY(after);
    QCOMPARE(after->seams[0].sides[0].size(), std::size_t(2));
    QVERIFY(std::abs(length(before) - length(*after) - 0.02) < dartRounding);
}

void tst_PatternDarts::mirrorImagesAreSewnToo() {
    IdSource ids{500};
    const auto after = addDart(tests::unsewnPanels(), front, dartOf(tests::unsewnPanels()), "dart", ids);
    QVERIFY(after);
    QCOMPARE(after->seams.size(), std::size_t(2)); // the front has one image
    QCOMPARE(after->seams[0].sides[0].front().piece, front);
    QCOMPARE(after->seams[1].sides[0].front().piece, PieceId("image"));
}

void tst_PatternDarts::aMouthOnACurveHasItsWidth() {
    IdSource ids{500};
    Pattern before = tests::unsewnPanels();
    const Dart dart = dartOf(before);
    before = *setEdgeShape(before, front, dart.edge, geometry::ArcShape{0.1});
    const double whole = edgeLength(*findPiece(before, front), dart.edge);
    const auto after = addDart(before, front, dart, "dart", ids);
    QVERIFY(after);
    const Piece& piece = *findPiece(*after, front);
    const LoopIndex legOut = *findEdge(piece, after->seams[0].sides[1].front().edge);
    const EdgeId rest = piece.outline.edges[(legOut.index + 1) % piece.outline.edges.size()].id;
    QVERIFY(std::abs(whole - edgeLength(piece, dart.edge) - edgeLength(piece, rest) - 0.02) < 1e-6);
}

void tst_PatternDarts::impossibleDartsAreRefused() {
    IdSource ids{500};
    const Pattern pattern = tests::unsewnPanels();
    const auto isRefused = [&](const Pattern& p, auto change) {
        Dart dart = dartOf(p);
        change(dart);
        return !addDart(p, front, dart, "dart", ids).has_value();
    };
    QVERIFY(isRefused(pattern, [](Dart& dart) { dart.width = 10; }));
    QVERIFY(isRefused(pattern, [](Dart& dart) { dart.width = 0; }));
    QVERIFY(isRefused(pattern, [](Dart& dart) { dart.middle = 0.01; }));
    QVERIFY(isRefused(pattern, [](Dart& dart) { dart.tip = {100, 100}; }));
    QVERIFY(isRefused(pattern, [](Dart& dart) { dart.edge = EdgeId("none"); }));
    QVERIFY(isRefused(*addNotch(pattern, front, {dartOf(pattern).edge, 0.5}), [](Dart&) {}));
    QVERIFY(!addDart(pattern, PieceId("none"), dartOf(pattern), "dart", ids));
}

void tst_PatternDarts::aSeamInTheMouthIsNamed() {
    IdSource ids{500};
    const EdgeId edge = dartOf(tests::unsewnPanels()).edge; // the mouth is a fifteenth of it, from 0.467 to 0.533
    const EdgePick other{PieceId("back"), findPiece(tests::unsewnPanels(), PieceId("back"))->outline.edges[0].id};
    for (const PieceId& piece : {front, PieceId("image")}) {
        const EdgePick within{piece, edge, 0.48, 0.52}, beyond{piece, edge, 0.48, 0.6};
        const Pattern sewn = *addSeam(tests::unsewnPanels(), std::span(&within, 1), std::span(&other, 1), "loop", ids);
        const auto refused = addDart(sewn, front, dartOf(sewn), "dart", ids);
        QVERIFY(!refused);
        QVERIFY(refused.error().text.find("The seam \"loop\"") != std::string::npos);
        const Pattern passing =
            *addSeam(tests::unsewnPanels(), std::span(&beyond, 1), std::span(&other, 1), "loop", ids);
        QCOMPARE(addDart(passing, front, dartOf(passing), "dart", ids)->seams[0].name, std::string("loop"));
    }
}

TOILE_TEST(tst_PatternDarts, QCoreApplication)
#include "tst_PatternDarts.moc"
