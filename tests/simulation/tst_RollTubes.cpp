// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/body/Arrangement.h"
#include "core/pattern/PatternMeasures.h"
#include "core/simulation/Clearing.h"
#include "core/simulation/RollTubes.h"
#include "tests/Suite.h"
#include "tests/simulation/UsualBody.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

const collision::BodySurface& surface() {
    static const collision::BodySurface made = std::move(*collision::BodySurface::create(usualBody().mesh));
    return made;
}

const geometry::Polyline& arm() {
    static const geometry::Polyline line = *body::limbLine(usualBody(), body::Limb::leftArm);
    return line;
}

/// A sleeve lies flat beside the left arm, facing outward, as patterns from elsewhere place it: e3 and e1
/// make it a tube.
pattern::Piece flatSleeve() {
    pattern::Piece piece = polygonPiece("sleeve", {{-0.2, -0.3}, {0.2, -0.3}, {0.2, 0}, {-0.2, 0}}, 0.02);
    piece.placement = pattern::Placement{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0.45, 1.3, 0}}, {}};
    return piece;
}

pattern::Seam underarm(const std::string& piece) {
    return seamBetween(piece + " underarm", piece, "e3", piece, "e1");
}

/// Half an armhole each: straight panels before and behind the shoulder, sewn to the sleeve's upper edge.
/// Their edges end at its corners, so that it faces upward and its seam lies beneath the arm.
pattern::Pattern sleeveAndArmhole() {
    pattern::Pattern pattern;
    pattern.fabrics.push_back(plainCloth());
    pattern.pieces.push_back(flatSleeve());
    for (const bool front : {true, false}) {
        pattern::Piece panel = polygonPiece(front ? "front" : "back", {{-0.2, 0}, {0, 0}, {0, 0.2}, {-0.2, 0.2}}, 0.02);
        const double side =
            front ? 1 : -1; // e1 runs up the armhole at the front; at the back the panel is turned round
        panel.placement = pattern::Placement{{{side, 0, 0}, {0, 1, 0}, {0, 0, side}, {0.18, 1.2, 0.1 * side}}, {}};
        if (!front)
            for (auto& vertex : panel.outline.vertices) vertex.position.x += 0.2; // e3 is the armhole
        pattern.pieces.push_back(std::move(panel));
    }
    pattern.seams.push_back(underarm("sleeve"));
    pattern::Seam toFront = seamBetween("to front", "sleeve", "e2", "front", "e1"),
                  toBack = seamBetween("to back", "sleeve", "e2", "back", "e3");
    toBack.sides[0][0].to = 0.5; // e2 runs from the right corner over the middle to the left one; on the left arm, seen
    toFront.sides[0][0].from = 0.5; // from above with the shoulder at the top, the back is to the right
    pattern.seams.push_back(toFront);
    pattern.seams.push_back(toBack);
    return pattern;
}

pattern::Pattern rolledOnly(const pattern::Pattern& pattern) {
    return rolledRound(pattern, flatTubesOf(pattern, usualBody()), surface());
}

double longestGap(const pattern::Pattern& pattern, const pattern::Seam& seam) {
    double longest = 0;
    const auto side = [&](int i) {
        std::vector<Vec3> points;
        const pattern::SeamPart& part = seam.sides[static_cast<std::size_t>(i)][0];
        for (const Vec2 p : pattern::partPoints(pattern, part, 1e-3))
            points.push_back(pattern::placed(*pattern::findPiece(pattern, part.piece)->placement, p));
        return points;
    };
    const auto a = side(0), b = side(1);
    for (std::size_t k = 0; k < 2; ++k)
        longest = std::max(longest, geometry::distance(k ? a.back() : a.front(), k ? b.back() : b.front()));
    return longest;
}

} // namespace

class tst_RollTubes : public QObject {
    Q_OBJECT
private slots:
    void aSleeveIsRolledRoundItsArm();
    void aPieceThatIsNotSewnToItselfStaysFlat();
    void aDartMakesNoTube();
    void itsSeamsAreAsShortAsTheyCanBe();
    void upsideDownItIsTurnedRound();
    void aCuffGoesToTheEndOfItsSleeve();
    void aSleeveOverTheHandIsClosedLast();
};

void tst_RollTubes::aSleeveIsRolledRoundItsArm() {
    pattern::Pattern pattern = sleeveAndArmhole();
    pattern.seams.resize(1); // alone: it stays where it is along the arm
    const pattern::Pattern arranged = rolledOnly(pattern);
    const pattern::Piece& sleeve = *arranged.pieces[0];
    QVERIFY(sleeve.placement->curl);
    QVERIFY(isTube(pointsOn(sleeve), *sleeve.placement));
    QVERIFY(isClear(pointsOn(sleeve), *sleeve.placement, surface()));
    for (const Vec2 p : pointsOn(sleeve)) { // it lies round the arm's line
        const Vec3 at = pattern::placed(*sleeve.placement, p);
        const Vec3 middle = geometry::frameAlong(arm(), geometry::nearestArcLength(arm(), at), {0, 0, 1}).origin;
        QVERIFY(std::abs(geometry::distance(at, middle) - sleeve.placement->curl->radius) < 0.005);
    }
    QVERIFY(longestGap(arranged, arranged.seams[0]) < 0.15);
}

void tst_RollTubes::aPieceThatIsNotSewnToItselfStaysFlat() {
    pattern::Pattern pattern = sleeveAndArmhole();
    pattern.seams.clear();
    QVERIFY(flatTubesOf(pattern, usualBody()).empty());
}

void tst_RollTubes::aDartMakesNoTube() {
    pattern::Pattern pattern = sleeveAndArmhole();
    pattern.seams = {seamBetween("dart", "sleeve", "e0", "sleeve", "e1")}; // they share a corner
    QVERIFY(flatTubesOf(pattern, usualBody()).empty());
}

void tst_RollTubes::itsSeamsAreAsShortAsTheyCanBe() {
    const pattern::Pattern arranged = rolledOnly(sleeveAndArmhole());
    const pattern::Placement& placement = *arranged.pieces[0]->placement;
    QVERIFY(placement.transform.axisZ.y > 0.4);                                              // the middle is uppermost
    QVERIFY(pattern::placed(placement, {0, 0}).y > pattern::placed(placement, {0, -0.3}).y); // its cap at the shoulder
    QVERIFY(pattern::placed(placement, {-0.1, 0}).z >
            pattern::placed(placement, {0.1, 0}).z); // the left half is the front's
}

void tst_RollTubes::upsideDownItIsTurnedRound() {
    pattern::Pattern pattern = sleeveAndArmhole();
    const pattern::Placement right = *rolledOnly(pattern).pieces[0]->placement;
    pattern::Piece turned = *pattern.pieces[0];
    turned.placement->transform.axisX = -turned.placement->transform.axisX;
    turned.placement->transform.axisY = -turned.placement->transform.axisY;
    turned.placement->transform.origin.y -= 0.3;
    pattern.pieces[0] = turned;
    const pattern::Placement found = *rolledOnly(pattern).pieces[0]->placement;
    QVERIFY(geometry::distance(pattern::placed(right, {0, -0.1}), pattern::placed(found, {0, -0.1})) < 1e-9);
}

void tst_RollTubes::aCuffGoesToTheEndOfItsSleeve() {
    pattern::Pattern pattern = sleeveAndArmhole();
    pattern::Piece cuff = polygonPiece("cuff", {{-0.1, -0.05}, {0.1, -0.05}, {0.1, 0}, {-0.1, 0}}, 0.02);
    cuff.placement = pattern::Placement{{{0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {0.6, 0.9, 0}}, {}};
    pattern.pieces.push_back(cuff);
    pattern.seams.push_back(underarm("cuff"));
    pattern.seams.push_back(seamBetween("wrist", "sleeve", "e0", "cuff", "e2"));
    const pattern::Pattern arranged = rolledOnly(pattern);
    const pattern::Piece& placed = *arranged.pieces[3];
    QVERIFY(isTube(pointsOn(placed), *placed.placement));
    QVERIFY(isClear(pointsOn(placed), *placed.placement, surface()));
    QVERIFY(longestGap(arranged, arranged.seams.back()) < 0.15); // both slits lie beneath the arm
}

void tst_RollTubes::aSleeveOverTheHandIsClosedLast() {
    pattern::Pattern pattern = sleeveAndArmhole();
    QCOMPARE(rolledOnly(pattern).seams[0].order, 0); // it ends above the elbow
    pattern::Piece longer = *pattern.pieces[0];
    for (auto& vertex : longer.outline.vertices)
        if (vertex.position.y < 0) vertex.position.y = -0.75;
    pattern.pieces[0] = longer;
    const pattern::Pattern arranged = rolledOnly(pattern);
    QCOMPARE(arranged.seams[0].order, 1);
    QCOMPARE(arranged.seams[1].order, 0);
}

TOILE_TEST(tst_RollTubes)
#include "tst_RollTubes.moc"
