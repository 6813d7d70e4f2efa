// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pattern/PatternTacks.h"
#include "tests/Suite.h"

#include "core/pattern/PatternContours.h"
#include "core/pattern/PatternPieces.h"
#include "tests/pattern/ErrorsOf.h"
#include "tests/pattern/TwoPanels.h"

#include <QTest>
#include <cmath>

using namespace toile;
using namespace toile::pattern;
using tests::back;
using tests::errorsOf;
using tests::front;
using tests::image;

class tst_PatternTacks : public QObject {
    Q_OBJECT
private slots:
    void aTackIsAddedAndRemoved();
    void aPlaceOutsideThePieceIsRefused();
    void theSamePlaceTwiceIsRefused();
    void anEndIsMovedWithinItsPiece();
    void aButtonHasADiameter();
    void ofAnImageThePlaceCountsInTheImage();
    void aHoleIsNoCloth();
    void aDeletedPieceTakesItsTacksAlong();
    void whatDoesNotFitIsNamed();
    void anIdIsNeverUsedTwice();
};

namespace {

/// Two panels, and a tack that holds one to the other.
Pattern tacked() {
    IdSource ids{50};
    return *addTack(tests::twoPanels(), {{{front, {0.1, 0.2}}, {back, {0.15, 0.3}}}}, "bar", ids);
}

const TackId bar("t50");

} // namespace

void tst_PatternTacks::aTackIsAddedAndRemoved() {
    const Pattern pattern = tacked();
    QVERIFY(errorsOf(pattern).empty());
    const Tack* tack = findTack(pattern, bar);
    QVERIFY(tack && tack->name == "bar" && !tack->buttonDiameter);
    QVERIFY(*removeTack(pattern, bar) == tests::twoPanels());
    QVERIFY(!removeTack(tests::twoPanels(), bar));
}

void tst_PatternTacks::aPlaceOutsideThePieceIsRefused() {
    IdSource ids{50};
    const Pattern pattern = tests::twoPanels();
    for (const ClothPoint& end : {ClothPoint{front, {-0.05, 0.2}}, ClothPoint{PieceId("none"), {0.1, 0.2}},
                                  ClothPoint{front, {std::nan(""), 0.2}}})
        QVERIFY(!addTack(pattern, {{end, {back, {0.1, 0.1}}}}, "", ids));
    QCOMPARE(ids.next, 50);
    QVERIFY(addTack(pattern, {{{front, {0, 0}}, {back, {0.3, 0.4}}}}, "", ids)); // corners are cloth
}

void tst_PatternTacks::theSamePlaceTwiceIsRefused() {
    IdSource ids{50};
    QVERIFY(!addTack(tests::twoPanels(), {{{front, {0.1, 0.1}}, {front, {0.1, 0.1}}}}, "", ids));
    QVERIFY(addTack(tests::twoPanels(), {{{front, {0.1, 0.1}}, {front, {0.2, 0.1}}}}, "pleat", ids));
}

void tst_PatternTacks::anEndIsMovedWithinItsPiece() {
    const auto moved = moveTackEnd(tacked(), bar, 1, {0.2, 0.35});
    QVERIFY(moved && findTack(*moved, bar)->ends[1].point == Vec2(0.2, 0.35));
    QVERIFY(!moveTackEnd(tacked(), bar, 1, {0.2, 0.45}));
    QVERIFY(!moveTackEnd(tacked(), TackId("none"), 1, {0.2, 0.35}));
}

void tst_PatternTacks::aButtonHasADiameter() {
    const auto button = setButtonDiameter(tacked(), bar, 0.011);
    QVERIFY(button && *findTack(*button, bar)->buttonDiameter == 0.011);
    QVERIFY(*setButtonDiameter(*button, bar, std::nullopt) == tacked());
    for (const double wrong : {0.0, -0.01, std::nan("")}) QVERIFY(!setButtonDiameter(tacked(), bar, wrong));
    QCOMPARE(findTack(*setTackOrder(*renameTack(tacked(), bar, "top"), bar, 3), bar)->order, 3);
}

void tst_PatternTacks::ofAnImageThePlaceCountsInTheImage() {
    IdSource ids{50};
    const Pattern pattern = tests::twoPanels(); // the image lies left of the line x = 0
    QVERIFY(addTack(pattern, {{{image, {-0.1, 0.2}}, {front, {0.1, 0.2}}}}, "", ids));
    QVERIFY(!addTack(pattern, {{{image, {0.1, 0.2}}, {front, {0.1, 0.2}}}}, "", ids));
}

void tst_PatternTacks::aHoleIsNoCloth() {
    Pattern pattern = tests::twoPanels();
    Piece piece = *pattern.pieces[1];
    Contour hole;
    hole.vertices = {{VertexId("h1"), {0.1, 0.1}}, {VertexId("h2"), {0.1, 0.2}}, {VertexId("h3"), {0.2, 0.2}}};
    hole.edges = {{EdgeId("g1"), {}, {}}, {EdgeId("g2"), {}, {}}, {EdgeId("g3"), {}, {}}};
    piece.holes = {hole};
    QVERIFY(!isOnCloth(pattern, piece, {0.12, 0.18}));
    QVERIFY(isOnCloth(pattern, piece, {0.1, 0.15})); // its border
    QVERIFY(isOnCloth(pattern, piece, {0.18, 0.12}));
}

void tst_PatternTacks::aDeletedPieceTakesItsTacksAlong() {
    const auto edited = deletePiece(tacked(), back);
    QVERIFY(edited && edited->pattern.tacks.empty());
    QVERIFY(std::ranges::any_of(edited->warnings, [](const Warning& w) { return w.place == "tack \"bar\""; }));
}

void tst_PatternTacks::whatDoesNotFitIsNamed() {
    Pattern pattern = tacked();
    pattern.tacks.push_back(pattern.tacks[0]);
    pattern.tacks[0].ends[0].piece = PieceId("none");
    pattern.tacks[0].buttonDiameter = 0;
    pattern.tacks[1].ends[1].point = {0.5, 0.5};
    const std::vector<std::string> expected{
        "tacks[0].a.piece: tack \"bar\": There is no piece \"none\".",
        "tacks[0].buttonDiameter: tack \"bar\": The diameter of a button must be a positive length.",
        "tacks[1].id: tack \"bar\": The id \"t50\" is given twice.",
        "tacks[1].b.point: tack \"bar\": A tack holds cloth: this point lies outside the piece \"back\"."};
    const auto errors = errorsOf(pattern);
    QCOMPARE(errors.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) QVERIFY2(errors[i] == expected[i], errors[i].c_str());
}

void tst_PatternTacks::anIdIsNeverUsedTwice() {
    QCOMPARE(firstFreeNumber(tacked()), 51);
}

TOILE_TEST(tst_PatternTacks)
#include "tst_PatternTacks.moc"
