// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/cloth/PaperSprings.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>
#include <random>

using namespace toile;
using namespace toile::fixtures;
using cloth::MembraneTriangle;
using cloth::Spring;

namespace {

MembraneTriangle triangle(const std::array<Vec2, 3>& corners, const material::MembraneStiffness& stiffness) {
    const Vec2 p = corners[1] - corners[0], q = corners[2] - corners[0];
    const double determinant = p.x * q.y - q.x * p.y;
    return {{0, 1, 2},
            {q.y / determinant, -q.x / determinant, -p.y / determinant, p.x / determinant},
            0.5 * determinant,
            stiffness};
}

/// Energy of the three springs under a small strain, over that of the membrane.
double energyRatio(const std::array<Vec2, 3>& corners, const MembraneTriangle& membrane, double xx, double yy,
                   double shear) {
    double springs = 0;
    for (const Spring& s : cloth::springsInsteadOf(membrane)) {
        const Vec2 e = corners[s.b] - corners[s.a];
        const double change = (xx * e.x * e.x + yy * e.y * e.y + shear * e.x * e.y) / length(e);
        springs += 0.5 * s.stiffness * change * change;
    }
    const auto& c = membrane.stiffness;
    return springs /
           (0.5 * membrane.area * (c.c11 * xx * xx + c.c22 * yy * yy + 2 * c.c12 * xx * yy + c.c33 * shear * shear));
}

/// ‖C_springs − C‖², in axes that do not matter.
double distanceOf(const MembraneTriangle& membrane, const std::array<Vec2, 3>& corners,
                  const std::array<Spring, 3>& springs) {
    const auto& c = membrane.stiffness;
    double tensor[3][3] = {{c.c11, c.c12, 0}, {c.c12, c.c22, 0}, {0, 0, 2 * c.c33}};
    tensor[0][1] = tensor[1][0] = c.c12;
    for (const Spring& s : springs) {
        const Vec2 e = corners[s.b] - corners[s.a];
        const double v[3] = {e.x * e.x / length(e), e.y * e.y / length(e), std::sqrt(2.0) * e.x * e.y / length(e)};
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) tensor[i][j] -= s.stiffness * v[i] * v[j] / membrane.area;
    }
    double sum = 0;
    for (const auto& row : tensor)
        for (const double value : row) sum += value * value;
    return sum;
}

} // namespace

/// The paper's cloth: what three springs can be of a membrane, and what they cannot.
class tst_PaperSprings : public QObject {
    Q_OBJECT

private slots:
    /// Central forces have C12 = C33; then an equilateral triangle is exactly the isotropic membrane.
    void anEquilateralTriangleIsExactForIsotropicClothOfSprings() {
        const double side = 0.02;
        const std::array<Vec2, 3> corners{Vec2{0, 0}, {side, 0}, {side / 2, side * std::sqrt(0.75)}};
        const MembraneTriangle membrane = triangle(corners, {.c11 = 300, .c22 = 300, .c12 = 100, .c33 = 100});
        for (const auto& [xx, yy, shear] :
             {std::array{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}, {1.0, -2.0, 0.5}})
            QVERIFY(std::abs(energyRatio(corners, membrane, xx, yy, shear) - 1) < 1e-9);
        const auto springs = cloth::springsInsteadOf(membrane);
        QVERIFY(std::abs(springs[0].stiffness - springs[2].stiffness) < 1e-9 * springs[0].stiffness);
        QVERIFY(std::abs(springs[0].restLength - side) < 1e-15);
    }

    /// No three springs that are nowhere negative are nearer to the membrane: tried by many that are a little other.
    void noOtherSpringsAreNearer() {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> anywhere(-1, 1);
        for (int n = 0; n < 50; ++n) {
            const std::array<Vec2, 3> corners{
                Vec2{0, 0}, {1, 0.4 * anywhere(random)}, {anywhere(random), 0.6 + 0.3 * anywhere(random)}};
            const MembraneTriangle membrane = triangle(corners, {.c11 = 900, .c22 = 1800, .c12 = 20, .c33 = 20});
            const auto springs = cloth::springsInsteadOf(membrane);
            const double least = distanceOf(membrane, corners, springs);
            for (const Spring& s : springs) QVERIFY(s.stiffness >= 0);
            for (int k = 0; k < 100; ++k) {
                auto others = springs;
                for (Spring& s : others) s.stiffness = std::max(0.0, s.stiffness + 30 * anywhere(random));
                QVERIFY(distanceOf(membrane, corners, others) >= least * (1 - 1e-12));
            }
        }
    }

    void onlySpringsAreLeft() {
        cloth::ClothModel model;
        Patch patch = gridPatch(evenLines(0.1, 5), evenLines(0.1, 5));
        const auto n = patch.rectangles.back().nodes; // a corner of triangles
        patch.rectangles.pop_back();
        patch.triangles = {{{n[0], n[1], n[2]}, {}}, {{n[0], n[2], n[3]}, {}}};
        QVERIFY(cloth::appendPatch(model, patch, wovenFabric(), {cloth::CellForm::springs}));
        QVERIFY(!model.triangles.empty() && !model.bending.empty());
        const auto triangles = static_cast<int>(model.triangles.size());
        const auto report = cloth::springsAlone(model, 15);
        QVERIFY(model.triangles.empty() && model.bending.empty() && model.twist.empty() && model.hinges.empty());
        QCOMPARE(report.triangles, triangles);
        QCOMPARE(report.flexionSprings, static_cast<int>(model.flexion.size()));
        QVERIFY(report.fitResidual > 0.01 && report.fitResidual < 1); // woven cloth is no cloth of three springs
        const auto x = flatPositions(patch);
        QVERIFY2(cloth::energy(model, x) < 1e-20, // flat as cut it is at rest
                 qPrintable(QString::number(cloth::energy(model, x))));
    }
};

TOILE_TEST(tst_PaperSprings)
#include "tst_PaperSprings.moc"
