// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/cloth/StrainGradients.h"
#include "tests/Suite.h"

#include <QTest>
#include <map>

using namespace toile;
using namespace toile::cloth;

namespace {

using Blocks = std::map<std::pair<int, int>, std::array<double, 9>>;

class Collected final : public HessianSink {
public:
    void add(int i, int j, const double (&block)[9]) override {
        auto& sum = blocks[{i, j}];
        for (int k = 0; k < 9; ++k) sum[k] += block[k];
    }
    Blocks blocks;
};

/// Somewhere in space, turned, as flat as it rests.
std::vector<Vec3> placed(std::initializer_list<Vec2> material) {
    const Vec3 u = normalized(Vec3{1, 2, -0.5}), v = normalized(cross(Vec3{0.3, -1, 2}, u));
    std::vector<Vec3> positions;
    for (const Vec2& m : material) positions.push_back(Vec3{0.4, 1.2, -0.1} + m.x * u + m.y * v);
    return positions;
}

ClothModel of(int particles) {
    ClothModel model;
    model.mass.assign(particles, 0.01);
    return model;
}

} // namespace

/// Where an element is at rest, its Hessian is Σ k·g·gᵀ over its strains, if nothing couples them.
class tst_StrainGradients : public QObject {
    Q_OBJECT
private slots:
    void theyMakeTheHessianOfClothAtRest_data() {
        QTest::addColumn<ClothModel>("model");
        QTest::addColumn<std::vector<Vec3>>("positions");
        const material::MembraneStiffness stiffness{.c11 = 300, .c22 = 500, .c12 = 0, .c33 = 40};
        ClothModel springs = of(2);
        springs.structural = {{0, 1, 0.05, 700}};
        springs.elastics = {{0, 1, 0.05, 30}};
        QTest::newRow("springs") << springs << placed({{0, 0}, {0.03, 0.04}});
        ClothModel stencils = of(4);
        stencils.bending = {{{0, 1, 2, -1}, {1, -2, 1, 0}, 3}};
        stencils.twist = {{{0, 1, 2, 3}, {1, -1, 1, -1}, 2}};
        QTest::newRow("stencils") << stencils << placed({{0, 0}, {0.03, 0}, {0.05, 0.01}, {0.02, 0.04}});
        ClothModel hinges = of(4);
        hinges.hinges = {{0, 1, 2, 3, 0, 0.01}};
        QTest::newRow("hinges") << hinges << placed({{0, 0}, {0.03, 0}, {0.01, 0.02}, {0.02, -0.03}});
        ClothModel triangles = of(3);
        triangles.triangles = {{{0, 1, 2}, {1 / 0.03, 0, 0, 1 / 0.02}, 0.0003, stiffness, -1}};
        QTest::newRow("triangles") << triangles << placed({{0, 0}, {0.03, 0}, {0, 0.02}});
        ClothModel cells = of(4);
        cells.cells = {{{0, 1, 2, 3}, 0.03, 0.02, stiffness, -1}};
        QTest::newRow("cells") << cells << placed({{0, 0}, {0.03, 0}, {0.03, 0.02}, {0, 0.02}});
    }
    void theyMakeTheHessianOfClothAtRest() {
        QFETCH(ClothModel, model);
        QFETCH(std::vector<Vec3>, positions);
        Collected expected;
        addHessian(model, positions, HessianForm::exact, expected);
        QVERIFY(!expected.blocks.empty());
        std::vector<StrainGradient> strains;
        strainGradients(model, positions, strains);
        Blocks found;
        double largest = 0;
        for (const StrainGradient& s : strains)
            for (int i = 0; i < 4; ++i)
                for (int j = 0; j < 4; ++j)
                    for (int k = 0; k < 9 && s.particles[i] >= 0 && s.particles[j] >= 0; ++k)
                        largest =
                            std::max(largest, std::abs(found[{s.particles[i], s.particles[j]}][k] +=
                                                       s.stiffness * s.gradient[i][k / 3] * s.gradient[j][k % 3]));
        for (const auto& [pair, block] : expected.blocks)
            for (int k = 0; k < 9; ++k) {
                const double difference = std::abs(block[k] - found[pair][k]);
                QVERIFY2(difference <= 1e-6 * largest, qPrintable(QString("%1 of %2").arg(difference).arg(largest)));
            }
    }

    void whatHasNoStiffnessHasNone() {
        ClothModel model = of(3);
        model.structural = {{0, 1, 0.05, 0}};
        model.triangles = {{{0, 1, 2}, {1 / 0.03, 0, 0, 1 / 0.02}, 0.0003, {}, -1}};
        std::vector<StrainGradient> strains;
        strainGradients(model, placed({{0, 0}, {0.03, 0}, {0, 0.02}}), strains);
        QVERIFY(strains.empty());
    }
};

TOILE_TEST(tst_StrainGradients, QCoreApplication)
#include "tst_StrainGradients.moc"
