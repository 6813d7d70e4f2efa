// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternPieces.h"
#include "tests/Suite.h"

#include "core/pattern/PatternCheck.h"
#include "core/pattern/PatternFabrics.h"
#include "core/pattern/PatternMeasures.h"
#include "core/pattern/PatternPlacement.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>
#include <numbers>

using namespace toile;
using namespace toile::pattern;
using tests::back;
using tests::front;
using tests::image;

class tst_PatternPieces : public QObject {
    Q_OBJECT
private slots:
    void theSamplePatternHasNoErrors();
    void aPieceWithATakenIdIsRefused();
    void aCopyIsTheSameWithIdsOfItsOwn();
    void aDeletedPieceTakesImagesSeamsAndPinsAlong();
    void movingAPieceOnTheTableLeavesItsShape();
    void laidOutPiecesDoNotCoverEachOther();
    void valuesWithoutSenseAreRefused();
    void aVertexIsPinnedOnce();
    void aPinIsSetToTheBody();
    void cornersOfARectangleAreRight();
    void aCornerIsMeasuredOnTheSideOfTheCloth();
    void aMirrorImageIsCongruentAndCounterClockwise();
    void aMirrorImageBeginsAsItsSource();
    void aStretchedPlacementIsRefused();
    void aMovedPlacementCarriesItsPoints();
    void aCurledPieceKeepsItsLengths();
    void aRollLaidAlongALineKeepsItsGirth();
    void aFabricInUseStays();
    void interfacingIsFusedAndTakenOff();
    void clothIsTheFabricWithItsInterfacing();
    void pliesAddUp();
    void freeNumbersAreAboveAllInUse();
};

namespace {}

void tst_PatternPieces::theSamplePatternHasNoErrors() {
    for (const Problem& problem : checkPattern(tests::twoPanels()))
        QVERIFY2(!problem.isError, toString(problem).c_str());
}

void tst_PatternPieces::aPieceWithATakenIdIsRefused() {
    QVERIFY(!addPiece(tests::twoPanels(), tests::rectangle("front", 1, 1)));
    QVERIFY(addPiece(tests::twoPanels(), tests::rectangle("sleeve", 1, 1)));
    QVERIFY(!addPiece(tests::twoPanels(), Piece{}));
}

void tst_PatternPieces::aCopyIsTheSameWithIdsOfItsOwn() {
    const Pattern pattern = tests::twoPanels();
    IdSource ids{firstFreeNumber(pattern)};
    const auto next = duplicatePiece(pattern, front, "second front", ids);
    QVERIFY(next && !hasErrors(checkPattern(*next)));
    const Piece &original = *findPiece(*next, front), &copy = *next->pieces.back();
    QVERIFY(copy.id != original.id && copy.name == "second front");
    QVERIFY(flattened(copy.outline, 1e-4) == flattened(original.outline, 1e-4));
    for (std::size_t i = 0; i < copy.outline.edges.size(); ++i) {
        QVERIFY(!findEdge(original, copy.outline.edges[i].id));
        QVERIFY(!findVertex(original, copy.outline.vertices[i].id));
    }
    QCOMPARE(copy.notches.size(), original.notches.size());
    for (const Notch& notch : copy.notches) QVERIFY(notch.edge == copy.outline.edges[1].id);
    QCOMPARE(next->seams.size(), pattern.seams.size());

    const auto image2 = duplicatePiece(pattern, image, "second image", ids);
    QVERIFY(image2 && image2->pieces.back()->mirror->source == front);
    QVERIFY(!duplicatePiece(pattern, PieceId("none"), "?", ids));
}

void tst_PatternPieces::aDeletedPieceTakesImagesSeamsAndPinsAlong() {
    const auto edited = deletePiece(tests::twoPanels(), front);
    QVERIFY(edited);
    QCOMPARE(edited->pattern.pieces.size(), std::size_t(1));
    QVERIFY(edited->pattern.seams.empty() && edited->pattern.pins.empty());
    QCOMPARE(edited->warnings.size(), std::size_t(4)); // the image, two seams and the pin
    QCOMPARE(edited->warnings[3].place, std::string("piece \"front\", pin \"v3\""));
    QVERIFY(!hasErrors(checkPattern(edited->pattern)));
}

void tst_PatternPieces::movingAPieceOnTheTableLeavesItsShape() {
    const Pattern before = tests::twoPanels(), after = *movePiece(before, image, {1, 2});
    QCOMPARE(after.pieces[2]->tablePosition, (Vec2{1, 2}));
    QVERIFY(resolved(after, *after.pieces[2]).outline == resolved(before, *before.pieces[2]).outline);
}

void tst_PatternPieces::laidOutPiecesDoNotCoverEachOther() {
    QVERIFY(piecesCoverEachOther(tests::twoPanels()));
    const Pattern after = laidOut(tests::twoPanels());
    QVERIFY(!piecesCoverEachOther(after));
    QVERIFY(after.pieces[0]->outline == tests::twoPanels().pieces[0]->outline);
}

void tst_PatternPieces::valuesWithoutSenseAreRefused() {
    const Pattern p = tests::twoPanels();
    QVERIFY(!setSpacing(p, front, 0) && !setSpacing(p, front, -0.02) && !setSpacing(p, front, std::nan("")));
    QVERIFY(!setGrain(p, front, std::nan("")) && !setSeamAllowance(p, front, -1) && !renamePiece(p, front, ""));
    QVERIFY(!setGrain(p, image, 0.5)); // comes from the source
    QVERIFY(!setSpacing(p, PieceId("nobody"), 0.02));
    QCOMPARE(setSpacing(p, front, 0.01)->pieces[0]->spacing, 0.01);
    QVERIFY(!setPressure(p, front, 1e6) && !setPressure(p, front, -1e6) && !setPressure(p, front, std::nan("")));
    QCOMPARE(setPressure(p, front, -20)->pieces[0]->pressure, -20.0);
}

void tst_PatternPieces::aVertexIsPinnedOnce() {
    IdSource ids{50};
    QVERIFY(!addPin(tests::twoPanels(), front, VertexId("v3"), ids));
    const Pattern pinned = *addPin(tests::twoPanels(), image, VertexId("v3"), ids);
    QCOMPARE(pinned.pins.size(), std::size_t(2));
    QVERIFY(*removePin(pinned, pinned.pins[1].id) == tests::twoPanels());
}

void tst_PatternPieces::aPinIsSetToTheBody() {
    const Pattern inSpace = tests::twoPanels(), toBody = *setPinToBody(inSpace, inSpace.pins[0].id, true);
    QVERIFY(toBody.pins[0].toBody && toBody != inSpace);
    QVERIFY(*setPinToBody(toBody, toBody.pins[0].id, false) == inSpace);
    QVERIFY(!setPinToBody(inSpace, PinId("nobody"), true));

    const auto remarks = [](const Pattern& pattern) {
        std::vector<std::string> places;
        for (const Problem& problem : checkPattern(pattern))
            if (problem.text.find("is frozen") != std::string::npos && !problem.isError)
                places.push_back(problem.place.path);
        return places;
    };
    QVERIFY(remarks(toBody).empty() && remarks(*setFrozen(inSpace, front, true)).empty());
    QCOMPARE(remarks(*setFrozen(toBody, front, true)), std::vector<std::string>{"pins[0].toBody"});
}

void tst_PatternPieces::cornersOfARectangleAreRight() {
    const Piece piece = tests::rectangle("a", 0.3, 0.4);
    for (const char* v : {"v1", "v2", "v3", "v4"})
        QVERIFY(std::abs(cornerAngle(piece, VertexId(v)) - std::numbers::pi / 2) < 1e-15);
    QCOMPARE(edgeLength(piece, EdgeId("right")), 0.4);
    QVERIFY(std::abs(areaOf(piece) - 0.12) < 1e-15);
}

void tst_PatternPieces::aCornerIsMeasuredOnTheSideOfTheCloth() {
    Piece piece = tests::rectangle("a", 0.3, 0.4);
    piece.outline.vertices[2].position = {0.1, 0.1}; // now a notch in the corner: an arrow head
    QVERIFY(cornerAngle(piece, VertexId("v3")) > std::numbers::pi);
    double sum = 0;
    for (const Vertex& v : piece.outline.vertices) sum += cornerAngle(piece, v.id);
    QVERIFY(std::abs(sum - 2 * std::numbers::pi) < 1e-12); // (n − 2)·π
}

void tst_PatternPieces::aMirrorImageIsCongruentAndCounterClockwise() {
    const Pattern pattern = tests::twoPanels();
    const Piece source = *pattern.pieces[0], seen = resolved(pattern, *pattern.pieces[2]);
    QVERIFY(geometry::signedArea(flattened(seen.outline, 1e-5)) > 0);
    for (const Edge& edge : source.outline.edges)
        QVERIFY(std::abs(edgeLength(source, edge.id) - edgeLength(seen, edge.id)) < 1e-12);
    for (const Vertex& v : source.outline.vertices) {
        const auto at = findVertex(seen, v.id);
        QVERIFY(geometry::distance(seen.outline.vertices[at->index].position, {-v.position.x, v.position.y}) < 1e-15);
    }
    // A part of the image's edge lies where the source's part lies, mirrored.
    const auto a = partPoints(pattern, {front, EdgeId("right"), 0.2, 0.6}, 1e-4),
               b = partPoints(pattern, {image, EdgeId("right"), 0.2, 0.6}, 1e-4);
    QVERIFY(geometry::distance(b.front(), {-a.front().x, a.front().y}) < 1e-15);
    const geometry::ArcLength along(curveOf(seen, *findEdge(seen, EdgeId("right")))); // runs the other way
    QVERIFY(geometry::distance(along.pointAt(0.8), b.front()) < 1e-11);
}

void tst_PatternPieces::aMirrorImageBeginsAsItsSource() {
    Pattern pattern = *setLayer(tests::twoPanels(), back, 2);
    pattern = *setPressure(pattern, back, -20);
    pattern = *setStrengthened(*setFrozen(pattern, back, true), back, true);
    pattern = *setPlies(pattern, back, 2);
    pattern = *setInterfacing(pattern, back, Interfacing{});
    IdSource ids{firstFreeNumber(pattern)};
    const Pattern mirroredBack = *addMirrorPiece(pattern, back, {0, 0}, {0, 1}, "other back", ids);
    const Piece &source = *findPiece(mirroredBack, back), &other = *mirroredBack.pieces.back();
    QCOMPARE(other.layer, 2);
    QCOMPARE(other.pressure, -20.0);
    QCOMPARE(other.plies, 2);
    QVERIFY(other.frozen && other.strengthened);
    QVERIFY(other.interfacing == source.interfacing && other.fabric == source.fabric);
}

void tst_PatternPieces::aStretchedPlacementIsRefused() {
    const Pattern p = tests::twoPanels();
    QVERIFY(!setPlacement(p, front, Placement{{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}, {}}));
    QVERIFY(!setPlacement(p, front, Placement{{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}, {}})); // a mirror
    QVERIFY(!setCurl(p, front, Curl{{0, 1}, 0}));
    QVERIFY(!setPlacement(p, front, std::nullopt)->pieces[0]->placement);
    QCOMPARE(setCurl(p, front, Curl{{0, 5}, 0.2})->pieces[0]->placement->curl->axis, (Vec2{0, 1}));
}

void tst_PatternPieces::aMovedPlacementCarriesItsPoints() {
    const Transform motion{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0.1, 0.2, 0.3}}; // a quarter turn round y
    const Pattern after = *movePlacement(tests::twoPanels(), front, motion);
    const Vec3 was = placed(*tests::twoPanels().pieces[0]->placement, {0.1, 0.2}),
               is = placed(*after.pieces[0]->placement, {0.1, 0.2});
    QVERIFY(distance(motion.point(was), is) < 1e-15);
    QVERIFY(!movePlacement(tests::twoPanels(), image, motion)); // not placed
}

void tst_PatternPieces::aCurledPieceKeepsItsLengths() {
    const Placement rolled{{}, Curl{{0, 1}, 0.1}};
    double length = 0;
    constexpr int steps = 1000; // chords of a circle: relative error (step/R)²/24 = 4e-7
    for (int i = 0; i < steps; ++i)
        length += distance(placed(rolled, {0.3 * i / steps, 0}), placed(rolled, {0.3 * (i + 1) / steps, 0}));
    QVERIFY(std::abs(length - 0.3) < 1e-6);
    QVERIFY(placed(rolled, {0.1, 0}).z < 0); // bends away from the right side
}

void tst_PatternPieces::aRollLaidAlongALineKeepsItsGirth() {
    const Placement straight{{}, Curl{{0, 1}, 0.1}},
        same{{}, Curl{{0, 1}, 0.1, BentLine{-0.3, {{0, -0.3, 0}, {0, 0.2, 0}}}}};
    for (const Vec2 p : {Vec2{0.1, -0.4}, Vec2{-0.05, 0}, Vec2{0.2, 0.3}}) // also beyond the line's ends
        QVERIFY(distance(placed(straight, p), placed(same, p)) < 1e-15);
    const Placement bent{{}, Curl{{0, 1}, 0.1, BentLine{0, {{0, 0, 0}, {0, 0.1, 0}, {0, 0.2, 0.05}, {0, 0.25, 0.15}}}}};
    for (const double y : {0.0, 0.07, 0.15, 0.4}) {
        double length = 0;
        for (int i = 0; i < 1000; ++i)
            length += distance(placed(bent, {3e-4 * i, y}), placed(bent, {3e-4 * (i + 1), y}));
        QVERIFY(std::abs(length - 0.3) < 1e-6); // as above
    }
    QVERIFY(!setCurl(tests::twoPanels(), front, Curl{{0, 1}, 0.1, BentLine{0, {{0, 0, 0}}}}));
    QVERIFY(!setCurl(tests::twoPanels(), front, Curl{{0, 1}, 0.1, BentLine{0, {{0, 0, 0}, {0, 0, 0}}}}));
    QCOMPARE(setCurl(tests::twoPanels(), front, bent.curl)->pieces[0]->placement->curl, bent.curl);
}

void tst_PatternPieces::aFabricInUseStays() {
    const Pattern p = tests::twoPanels();
    QVERIFY(!removeFabric(p, FabricId("cotton")));
    Fabric silk;
    silk.id = FabricId("silk");
    const Pattern two = *addFabric(p, silk);
    QVERIFY(!addFabric(two, silk));
    QVERIFY(*removeFabric(two, FabricId("silk")) == p);
    QCOMPARE(setPieceFabric(two, front, FabricId("silk"))->pieces[0]->fabric, FabricId("silk"));
    QVERIFY(!setPieceFabric(two, front, FabricId("wool")));
    silk.thickness = -1;
    QVERIFY(!replaceFabric(two, silk));
}

void tst_PatternPieces::interfacingIsFusedAndTakenOff() {
    const Pattern plain = tests::twoPanels();
    const auto fused = setInterfacing(plain, front, Interfacing{});
    QVERIFY(fused && !hasErrors(checkPattern(*fused)));
    QVERIFY(findPiece(*fused, front)->interfacing && !findPiece(*fused, image)->interfacing);
    QVERIFY(*setInterfacing(*fused, front, std::nullopt) == plain);
    QVERIFY(!setInterfacing(plain, front, Interfacing{.bendingFactor = 0.5}));
    QVERIFY(!setInterfacing(plain, PieceId("nobody"), Interfacing{}));
}

void tst_PatternPieces::clothIsTheFabricWithItsInterfacing() {
    const Pattern plain = tests::twoPanels();
    const Pattern fused = *setInterfacing(plain, front, Interfacing{});
    QVERIFY(*clothOf(plain, *findPiece(plain, front)) == *plain.fabrics[0]);
    QVERIFY(*clothOf(fused, *findPiece(fused, front)) == material::fused(*plain.fabrics[0], Interfacing{}));
    QVERIFY(!clothOf(plain, Piece{}));
}

void tst_PatternPieces::pliesAddUp() {
    const Pattern plain = tests::twoPanels();
    const auto doubled = setPlies(plain, front, 2);
    QVERIFY(doubled && !hasErrors(checkPattern(*doubled)));
    const Fabric one = *clothOf(plain, *findPiece(plain, front)), two = *clothOf(*doubled, *findPiece(*doubled, front));
    QCOMPARE(two.arealDensity, 2 * one.arealDensity);
    QCOMPARE(two.weftStiffness, 2 * one.weftStiffness);
    QCOMPARE(two.warpBending, 2 * one.warpBending);
    QCOMPARE(two.thickness, 2 * one.thickness);
    QCOMPARE(two.friction, one.friction);
    const Pattern fused = *setInterfacing(*doubled, front, Interfacing{.bendingFactor = 9, .arealDensity = 0.05});
    const Fabric stiff = *clothOf(fused, *findPiece(fused, front));
    QVERIFY(std::abs(stiff.warpBending / one.warpBending - 10) < 1e-12); // one ply of nine, one of one
    QVERIFY(std::abs(stiff.arealDensity - 2 * one.arealDensity - 0.05) < 1e-12);
    QVERIFY(*setPlies(*doubled, front, 1) == plain);
    QVERIFY(!setPlies(plain, front, 0) && !setPlies(plain, front, mostPlies + 1));
    Pattern wrong = *doubled;
    Piece none = *findPiece(wrong, front);
    none.plies = 0;
    *std::ranges::find_if(wrong.pieces, [](const auto& p) { return p->id == front; }) = none;
    QVERIFY(hasErrors(checkPattern(wrong)));
}

void tst_PatternPieces::freeNumbersAreAboveAllInUse() {
    Pattern p = tests::twoPanels();
    QCOMPARE(firstFreeNumber(p), 5); // v4
    p.seams[0].id = SeamId("side 17");
    QCOMPARE(firstFreeNumber(p), 18);
    IdSource ids{firstFreeNumber(p)};
    QCOMPARE(ids.take<SeamId>(), SeamId("s18"));
    QCOMPARE(ids.take<VertexId>(), VertexId("v19"));
}

TOILE_TEST(tst_PatternPieces)
#include "tst_PatternPieces.moc"
