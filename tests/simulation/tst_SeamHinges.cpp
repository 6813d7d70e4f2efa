// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"

#include <QTest>
#include <numbers>

using namespace toile;
using namespace toile::simulation;

namespace {

pattern::Pattern squares() {
    return twoSquares(0.05).pattern;
} // four cells along the seam

/// The two squares with their seam merged at once.
Garment sewn(const pattern::Pattern& pattern) {
    auto mesh = meshing::meshGarment(*meshInputOf(pattern));
    return *makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), {true});
}

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
    const pattern::Pattern pattern = squares();
    auto mesh = meshing::meshGarment(*meshInputOf(pattern));
    const auto garment = makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(*mesh)), {false});
    QVERIFY(garment);
    QVERIFY(garment->model.hinges.empty());
}

void tst_SeamHinges::everyEdgeOfAMergedSeamHasTwo() { // between two rectangles: one at each end of the edge
    const Garment garment = sewn(squares());
    QCOMPARE(cellsAlongTheSeam(garment), std::size_t(4));
    QCOMPARE(garment.model.hinges.size(), 2 * cellsAlongTheSeam(garment));
}

void tst_SeamHinges::flatSquaresAreAtRest() {
    for (const cloth::Hinge& hinge : sewn(squares()).model.hinges) QCOMPARE(hinge.restAngle, 0.0);
}

void tst_SeamHinges::theFoldAngleIsTheRestAngle() {
    pattern::Pattern pattern = squares();
    pattern.seams[0].foldAngle = std::numbers::pi / 2;
    for (const cloth::Hinge& hinge : sewn(pattern).model.hinges) QCOMPARE(hinge.restAngle, std::numbers::pi / 2);
}

void tst_SeamHinges::theFactorMultipliesTheStiffness() {
    pattern::Pattern stiff = squares();
    stiff.seams[0].stiffnessFactor = 3;
    const Garment plain = sewn(squares()), stiffened = sewn(stiff);
    QCOMPARE(stiffened.model.hinges.size(), plain.model.hinges.size());
    for (std::size_t i = 0; i < plain.model.hinges.size(); ++i)
        QVERIFY(std::abs(stiffened.model.hinges[i].stiffness / plain.model.hinges[i].stiffness - 3) < 1e-12);
}

void tst_SeamHinges::togetherTheyBendAsTheClothDoes() {
    // A fold by θ between cells of width w is the curvature θ/w over the length e: E = ½ B e θ²/w, so Σk = B·e/w.
    const pattern::Pattern pattern = squares();
    const Garment garment = sewn(pattern);
    double sum = 0;
    for (const cloth::Hinge& hinge : garment.model.hinges) sum += hinge.stiffness;
    const double length = 0.2, width = 0.2 / 4;
    QVERIFY(std::abs(sum / (pattern.fabrics[0]->weftBending * length / width) - 1) < 1e-9);
}

void tst_SeamHinges::aSeamSewnTheWrongWayRoundHasNone() {
    pattern::Pattern pattern = squares();
    pattern.seams[0].sides[1][0].reversed = !pattern.seams[0].sides[1][0].reversed;
    QVERIFY(sewn(pattern).model.hinges.empty());
}

void tst_SeamHinges::clothWithoutBendingStiffnessHasNone() {
    pattern::Pattern pattern = squares();
    material::Fabric fabric = *pattern.fabrics[0];
    fabric.warpBending = fabric.weftBending = fabric.biasBending = 0;
    pattern.fabrics[0] = fabric;
    QVERIFY(sewn(pattern).model.hinges.empty());
}

QTEST_APPLESS_MAIN(tst_SeamHinges)
#include "tst_SeamHinges.moc"
