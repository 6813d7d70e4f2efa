// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"

#include <QTest>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

namespace {

pattern::Pattern squares() {
    return twoSquares(0.05).pattern;
} // four cells along the seam

std::size_t cellsAlongTheSeam(const Garment& garment) {
    return garment.mesh->seams[0].pairs.size() - 1;
}

} // namespace

class tst_SeamHinges : public QObject {
    Q_OBJECT
private slots:
    void anOpenSeamHasNone();
    void everyEdgeOfAMergedSeamHasTwo();
    void flatSquaresAreAtRest();
    void theFoldAngleIsTheRestAngle();
    void theFactorMultipliesTheStiffness();
    void togetherTheyBendAsTheClothDoes();
    void aSeamSewnTheWrongWayRoundHasNone();
    void clothWithoutBendingStiffnessHasNone();
};

void tst_SeamHinges::anOpenSeamHasNone() {
    const auto garment = tryGarmentOf(squares());
    QVERIFY(garment);
    QVERIFY(garment->model.hinges.empty());
}

void tst_SeamHinges::everyEdgeOfAMergedSeamHasTwo() { // between two rectangles: one at each end of the edge
    const Garment garment = garmentOf(squares(), true);
    QCOMPARE(cellsAlongTheSeam(garment), std::size_t(4));
    QCOMPARE(garment.model.hinges.size(), 2 * cellsAlongTheSeam(garment));
}

void tst_SeamHinges::flatSquaresAreAtRest() {
    for (const cloth::Hinge& hinge : garmentOf(squares(), true).model.hinges) QCOMPARE(hinge.restAngle, 0.0);
}

void tst_SeamHinges::theFoldAngleIsTheRestAngle() {
    pattern::Pattern pattern = squares();
    pattern.seams[0].foldAngle = std::numbers::pi / 2;
    for (const cloth::Hinge& hinge : garmentOf(pattern, true).model.hinges)
        QCOMPARE(hinge.restAngle, std::numbers::pi / 2);
}

void tst_SeamHinges::theFactorMultipliesTheStiffness() {
    pattern::Pattern stiff = squares();
    stiff.seams[0].stiffnessFactor = 3;
    const Garment plain = garmentOf(squares(), true), stiffened = garmentOf(stiff, true);
    QCOMPARE(stiffened.model.hinges.size(), plain.model.hinges.size());
    for (std::size_t i = 0; i < plain.model.hinges.size(); ++i)
        QVERIFY(std::abs(stiffened.model.hinges[i].stiffness / plain.model.hinges[i].stiffness - 3) < 1e-12);
}

void tst_SeamHinges::togetherTheyBendAsTheClothDoes() {
    // A fold by θ between cells of width w is the curvature θ/w over the length e: E = ½ B e θ²/w, so Σk = B·e/w.
    const pattern::Pattern pattern = squares();
    const Garment garment = garmentOf(pattern, true);
    double sum = 0;
    for (const cloth::Hinge& hinge : garment.model.hinges) sum += hinge.stiffness;
    const double length = 0.2, width = 0.2 / 4;
    QVERIFY(std::abs(sum / (pattern.fabrics[0]->weftBending * length / width) - 1) < 1e-9);
}

void tst_SeamHinges::aSeamSewnTheWrongWayRoundHasNone() {
    pattern::Pattern pattern = squares();
    pattern.seams[0].sides[1][0].reversed = !pattern.seams[0].sides[1][0].reversed;
    QVERIFY(garmentOf(pattern, true).model.hinges.empty());
}

void tst_SeamHinges::clothWithoutBendingStiffnessHasNone() {
    pattern::Pattern pattern = squares();
    material::Fabric fabric = *pattern.fabrics[0];
    fabric.warpBending = fabric.weftBending = fabric.biasBending = 0;
    pattern.fabrics[0] = fabric;
    QVERIFY(garmentOf(pattern, true).model.hinges.empty());
}

TOILE_TEST(tst_SeamHinges)
#include "tst_SeamHinges.moc"
