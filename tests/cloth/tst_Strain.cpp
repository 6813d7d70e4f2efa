// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Strain.h"
#include "tests/Suite.h"

#include <QTest>
#include <algorithm>
#include <cmath>

using namespace toile;
using namespace toile::cloth;
using geometry::Vec2;

namespace {

/// A square of n × n cells, one side at the origin, with triangles in the last column of cells.
Patch squareOf(double side, int n) {
    Patch patch;
    const auto node = [&](int column, int row) { return row * (n + 1) + column; };
    for (int row = 0; row <= n; ++row)
        for (int column = 0; column <= n; ++column)
            patch.material.push_back({side * column / n - side / 2, side * row / n - side / 2});
    for (int row = 0; row < n; ++row)
        for (int column = 0; column < n; ++column) {
            const int a = node(column, row), b = node(column + 1, row), c = node(column + 1, row + 1),
                      d = node(column, row + 1);
            if (column < n - 1) {
                patch.rectangles.push_back({{a, b, c, d}, {}});
            } else {
                patch.triangles.push_back({{a, b, c}, {}});
                patch.triangles.push_back({{a, c, d}, {}});
            }
        }
    return patch;
}

std::vector<Vec2> middlesOf(const Patch& patch) {
    std::vector<Vec2> middles;
    const auto add = [&](const auto& nodes) {
        Vec2 sum;
        for (const int node : nodes) sum = sum + patch.material[node];
        middles.push_back(sum / static_cast<double>(nodes.size()));
    };
    for (const PatchRectangle& cell : patch.rectangles) add(cell.nodes);
    for (const PatchTriangle& cell : patch.triangles) add(cell.nodes);
    return middles;
}

/// The strain of a function of the place, in the middle of each element.
template <class Field>
std::vector<Strain> strainsBy(const Patch& patch, const Field& field) {
    std::vector<Strain> strains;
    for (const Vec2 p : middlesOf(patch)) {
        const double cell = patch.material[1].x - patch.material[0].x;
        const bool isTriangle = strains.size() >= patch.rectangles.size();
        strains.push_back(
            {.warp = field(p), .weft = -field(p), .shear = 2 * field(p), .area = cell * cell * (isTriangle ? 0.5 : 1)});
    }
    return strains;
}

double largest(const std::vector<Strain>& strains) {
    return std::ranges::max(strains, {}, &Strain::warp).warp;
}

} // namespace

class tst_Strain : public QObject {
    Q_OBJECT
private slots:
    void evenStrainStaysWhatItIs();
    void largeElementsAreLeftAsTheyAre();
    void theMeanIsThatOfAllPairs();
    void whatHasNoBoundInAPointHasOneRoundIt();
};

void tst_Strain::evenStrainStaysWhatItIs() {
    const Patch patch = squareOf(0.1, 20);
    for (const Strain& mean : meanStrains(patch, strainsBy(patch, [](Vec2) { return 0.03; }), 0.012)) {
        QVERIFY(std::abs(mean.warp - 0.03) < 1e-15);
        QVERIFY(std::abs(mean.weft + 0.03) < 1e-15);
        QVERIFY(std::abs(mean.shear - 0.06) < 1e-15);
    }
}

void tst_Strain::largeElementsAreLeftAsTheyAre() {
    const Patch patch = squareOf(0.2, 10); // of 20 mm; the middles of two triangles of a cell are 9.4 mm apart
    const std::vector<Strain> strains = strainsBy(patch, [](Vec2 p) { return std::sin(40 * p.x) + p.y; });
    const std::vector<Strain> means = meanStrains(patch, strains, 0.005);
    for (std::size_t i = 0; i < strains.size(); ++i) {
        QVERIFY(std::abs(means[i].warp - strains[i].warp) < 1e-15);
        QCOMPARE(means[i].area, strains[i].area);
    }
}

void tst_Strain::theMeanIsThatOfAllPairs() {
    const double radius = 0.011;
    const Patch patch = squareOf(0.1, 23);
    const std::vector<Vec2> middles = middlesOf(patch);
    const std::vector<Strain> strains = strainsBy(patch, [](Vec2 p) { return std::cos(60 * p.x) * (1 + 5 * p.y); });
    const std::vector<Strain> means = meanStrains(patch, strains, radius);
    for (std::size_t i = 0; i < middles.size(); ++i) {
        double sum = 0, area = 0;
        for (std::size_t k = 0; k < middles.size(); ++k)
            if (distance(middles[i], middles[k]) <= radius) {
                sum += strains[k].area * strains[k].weft;
                area += strains[k].area;
            }
        QVERIFY(std::abs(means[i].weft - sum / area) < 1e-13);
    }
}

/// Strain beside the tip of a slit grows with 1/√r: with the smallest element without end, in the mean over a disc of
/// radius R to 4/3 of what it is at R.
void tst_Strain::whatHasNoBoundInAPointHasOneRoundIt() {
    const double radius = 0.005;
    const auto besideTip = [](Vec2 p) { return 0.001 / std::sqrt(length(p)); };
    double before = 0;
    for (const int n : {40, 80, 160}) { // no middle in the tip itself
        const Patch patch = squareOf(0.04, n);
        const std::vector<Strain> strains = strainsBy(patch, besideTip);
        QVERIFY(largest(strains) > 1.3 * before);
        before = largest(strains);
        const double expected = 4.0 / 3 * besideTip({radius, 0}), found = largest(meanStrains(patch, strains, radius));
        QVERIFY2(std::abs(found - expected) < 0.05 * expected,
                 qPrintable(QString("%1 of %2").arg(found).arg(expected)));
    }
}

TOILE_TEST(tst_Strain, QCoreApplication)
#include "tst_Strain.moc"
