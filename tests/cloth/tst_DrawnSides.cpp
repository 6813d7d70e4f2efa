// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>

using namespace toile;
using namespace toile::fixtures;

namespace {

constexpr double width = 0.02, height = 0.01;

/// One rectangle whose lower and upper sides are drawn up to these parts of their lengths.
Patch drawnRectangle(double lower, double upper) {
    Patch patch = gridPatch({0, width}, {0, height});
    patch.drawn = {{{0, 1}, lower}, {{2, 3}, upper}};
    return patch;
}

/// One rectangle cut into two triangles.
Patch drawnTriangles(double lower, double upper) {
    Patch patch = trianglePatch({0, width}, {0, height});
    patch.drawn = {{{0, 1}, lower}, {{2, 3}, upper}};
    return patch;
}

double stretchEnergy(const ClothModel& model, const std::vector<Vec3>& x) {
    const cloth::ElasticEnergy energy = cloth::elasticEnergy(model, x);
    return energy.total() - energy.bending;
}

/// The corners of the rectangle with its weft sides shortened about their middles.
std::vector<Vec3> corners(double lower, double upper) {
    const double x = 0.5 * width, l = lower * x, u = upper * x;
    return {{x - l, 0, 0}, {x + l, 0, 0}, {x - u, height, 0}, {x + u, height, 0}};
}

} // namespace

class tst_DrawnSides : public QObject {
    Q_OBJECT
private slots:
    void aCellDrawnUpOnBothSidesIsAtRestAsANarrowerOne() {
        for (const Fabric& fabric : {wovenFabric(), knitFabric()}) {
            const ClothModel model = modelOf(drawnRectangle(0.5, 0.5), fabric);
            const double flat = stretchEnergy(model, corners(1, 1));
            QVERIFY(flat > 1e-6);
            QVERIFY(stretchEnergy(model, corners(0.5, 0.5)) < 1e-12 * flat);
        }
    }
    void aDrawnTriangleIsAtRestWithItsSideShortAndItsHeightKept() {
        Patch patch = drawnTriangles(0.5, 1);
        std::erase_if(patch.triangles, [](const auto& t) { return std::ranges::count(t.nodes, 1) == 0; });
        patch.triangles.resize(1);
        std::vector<Vec3> x = corners(0.5, 1);
        const ClothModel model = modelOf(patch, wovenFabric());
        QVERIFY(stretchEnergy(model, x) < 1e-12 * stretchEnergy(model, corners(1, 1)));
    }
    /// A trapezium whose legs keep their length: for springs its height is less than the cell's.
    void aCellDrawnUpOnOneSideIsAtRestAsATrapezium() {
        const ClothModel model = modelOf(drawnRectangle(0.5, 1), wovenFabric());
        std::vector<Vec3> x = corners(0.5, 1);
        const double lean = 0.25 * width;
        for (const int upper : {2, 3}) x[upper].y = std::sqrt(height * height - lean * lean);
        QVERIFY(stretchEnergy(model, x) < 1e-12 * stretchEnergy(model, corners(1, 1)));
    }
    void aKnitDrawnUpOnOneSideIsAtRestAsATrapezium() {
        const ClothModel model = modelOf(drawnRectangle(0.5, 1), knitFabric());
        QVERIFY(model.cells.empty());
        QCOMPARE(int(model.triangles.size()), 2);
        QVERIFY(stretchEnergy(model, corners(0.5, 1)) < 1e-12 * stretchEnergy(model, corners(1, 1)));
    }
    void massStaysThatOfTheClothAsItWasCut() {
        for (const Fabric& fabric : {wovenFabric(), knitFabric()})
            for (const Patch& patch : {drawnRectangle(0.5, 1), drawnTriangles(0.5, 1)}) {
                double sum = 0;
                for (const double mass : modelOf(patch, fabric).mass) sum += mass;
                QVERIFY(std::abs(sum - fabric.arealDensity * width * height) < 1e-12 * sum);
            }
    }
    void onlyTheCellsBesideTheStitchingChange() {
        Patch patch = gridPatch(evenLines(3 * width, 3), evenLines(2 * height, 2));
        const ClothModel plain = modelOf(patch, wovenFabric());
        patch.drawn = {{{1, 2}, 0.5}};
        const ClothModel drawn = modelOf(patch, wovenFabric());
        QCOMPARE(drawn.structural.size(), plain.structural.size());
        int changed = 0;
        for (std::size_t i = 0; i < plain.structural.size(); ++i)
            changed += drawn.structural[i].restLength != plain.structural[i].restLength;
        for (std::size_t i = 0; i < plain.shear.size(); ++i)
            changed += drawn.shear[i].restLength != plain.shear[i].restLength;
        QCOMPARE(changed, 3); // the side and both diagonals of its cell
    }
};

TOILE_TEST(tst_DrawnSides, QCoreApplication)
#include "tst_DrawnSides.moc"
