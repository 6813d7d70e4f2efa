// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Flexion.h"
#include "core/cloth/Forces.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>

using namespace toile;
using namespace toile::fixtures;

namespace {

constexpr double stripLength = 0.1, wanted = 20; // [m], [1/m]

/// A strip along weft with unequal columns, without shear and twist.
ClothModel strip(const Patch& patch) {
    ClothModel model;
    if (!cloth::appendPatch(model, patch, wovenFabric())) qFatal("a strip");
    model.shear.clear();
    model.twist.clear();
    return model;
}

std::vector<double> columns(int cells, double unequal) {
    std::vector<double> lines = evenLines(stripLength, cells);
    for (int i = 1; i < cells; i += 2) lines[i] += unequal * stripLength / cells;
    return lines;
}

/// Bent on to a circle of the curvature, every cell as long as it was. The first row of nodes tells the
/// columns.
std::vector<Vec3> bent(const Patch& patch, double curvature) {
    std::vector<double> angles{0};
    for (std::size_t n = 1; patch.material[n].y == patch.material[0].y; ++n)
        angles.push_back(angles.back() +
                         2 * std::asin((patch.material[n].x - patch.material[n - 1].x) * curvature / 2));
    std::vector<Vec3> x;
    for (std::size_t n = 0; n < patch.material.size(); ++n) {
        const double angle = angles[n % angles.size()];
        x.push_back({std::sin(angle) / curvature, patch.material[n].y, (1 - std::cos(angle)) / curvature});
    }
    return x;
}

/// Moment of the bent strip times its length: dE/dκ [N·m²].
double momentAt(const ClothModel& model, const Patch& patch, double curvature) {
    const double d = 1e-3 * curvature;
    return (cloth::energy(model, bent(patch, curvature + d)) - cloth::energy(model, bent(patch, curvature - d))) /
           (2 * d);
}

} // namespace

class tst_Flexion : public QObject {
    Q_OBJECT

private slots:
    void atItsCurvatureTheMomentIsTheFabricsOnEveryMesh() {
        for (const auto& [cells, unequal] : {std::pair{16, 0.0}, {32, 0.0}, {32, 0.3}}) {
            const Patch patch = gridPatch(columns(cells, unequal), evenLines(0.02, 2));
            const ClothModel smooth = strip(patch);
            ClothModel springs = smooth;
            const auto report = cloth::flexionInsteadOfBending(springs, wanted);
            QVERIFY(report.springs > 0 && springs.bending.empty());
            const double expected = momentAt(smooth, patch, wanted);
            QVERIFY(std::abs(momentAt(springs, patch, wanted) - expected) < 0.01 * expected);
        }
    }

    void theMomentGrowsWithTheCubeOfTheCurvature() {
        const Patch patch = gridPatch(columns(32, 0), evenLines(0.02, 2));
        ClothModel springs = strip(patch);
        (void)cloth::flexionInsteadOfBending(springs, wanted);
        const double ratio = momentAt(springs, patch, wanted) / momentAt(springs, patch, wanted / 2);
        QVERIFY(std::abs(ratio - 8) < 0.1); // so flat cloth does not resist at all
    }

    void springsJoinEverySecondNodeOfALine() {
        const Patch patch = gridPatch(evenLines(0.03, 3), evenLines(0.02, 2));
        ClothModel springs = strip(patch);
        const auto report = cloth::flexionInsteadOfBending(springs, wanted);
        QCOMPARE(report.dropped, 0);
        for (const auto& spring : springs.flexion)
            QVERIFY(std::abs(distance(patch.material[spring.a], patch.material[spring.b]) - spring.restLength) < 1e-15);
    }

    void whatIsNoLineIsDroppedAndCounted() {
        const Patch patch = trianglePatch(evenLines(0.03, 3), evenLines(0.02, 2));
        ClothModel model;
        QVERIFY(cloth::appendPatch(model, patch, wovenFabric()));
        const auto before = model.bending.size();
        const auto report = cloth::flexionInsteadOfBending(model, wanted);
        QCOMPARE(report.springs, 0);
        QCOMPARE(report.dropped, static_cast<int>(before));
        QVERIFY(model.flexion.empty());
    }
};

TOILE_TEST(tst_Flexion)
#include "tst_Flexion.moc"
