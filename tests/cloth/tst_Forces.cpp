// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>
#include <map>

using namespace toile;
using namespace toile::fixtures;

namespace {

struct DenseSink : cloth::HessianSink {
    explicit DenseSink(int particles) : n(3 * particles), values(std::size_t(n) * n, 0.0) {}
    void add(int i, int j, const double (&block)[9]) override {
        for (int p = 0; p < 3; ++p)
            for (int q = 0; q < 3; ++q) values[std::size_t(3 * i + p) * n + 3 * j + q] += block[3 * p + q];
    }
    int n;
    std::vector<double> values;
};

std::vector<Vec3> forcesOf(const ClothModel& model, const std::vector<Vec3>& x) {
    std::vector<Vec3> forces(x.size());
    cloth::addForces(model, x, forces);
    return forces;
}

struct Case {
    ClothModel model;
    std::vector<Vec3> positions;
};

/// One small cloth for each kind of element, crumpled by a fifth of its spacing.
Case caseOf(const QString& kind) {
    const auto lines = evenLines(0.03, 3);
    Case c;
    if (kind == "springs") c.model = modelOf(gridPatch(lines, lines), wovenFabric());
    if (kind == "triangles") c.model = modelOf(trianglePatch(lines, lines), wovenFabric());
    if (kind == "membrane cells") c.model = modelOf(gridPatch(lines, lines), knitFabric());
    if (kind == "knit triangles") c.model = modelOf(trianglePatch(lines, lines), knitFabric());
    if (kind == "two regions") c.model = modelOf(twoRegionPatch(0.02, 2, 0.02, 2, 0.04, 4), wovenFabric());
    if (kind == "hinge") {
        c.model.mass.assign(4, 0.001);
        c.model.hinges.push_back({0, 1, 2, 3, 0.3, 2e-3});
        c.positions = {{0, 0, 0}, {0, 0.012, 0.001}, {-0.01, 0.004, 0.006}, {0.011, 0.007, 0.002}};
        return c;
    }
    const Patch shape = kind == "two regions" ? twoRegionPatch(0.02, 2, 0.02, 2, 0.04, 4) : gridPatch(lines, lines);
    c.positions = flatPositions(shape);
    shake(c.positions, 0.002);
    return c;
}

} // namespace

class tst_Forces : public QObject {
    Q_OBJECT

    static void kinds() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"springs", "triangles", "membrane cells", "knit triangles", "two regions", "hinge"})
            QTest::newRow(kind) << kind;
    }

private slots:
    void forceIsMinusTheGradientOfEnergy_data() { kinds(); }
    void forceIsMinusTheGradientOfEnergy() {
        QFETCH(QString, kind);
        auto [model, x] = caseOf(kind);
        const auto forces = forcesOf(model, x);
        double largest = 0, worst = 0;
        constexpr double d = 1e-7; // [m]; central differences: error d² and rounding 1e-16·E/d, both far below
        for (std::size_t p = 0; p < x.size(); ++p)
            for (int i = 0; i < 3; ++i) {
                const double at = x[p][i];
                x[p][i] = at + d;
                const double above = cloth::energy(model, x);
                x[p][i] = at - d;
                const double below = cloth::energy(model, x);
                x[p][i] = at;
                largest = std::max(largest, std::abs(forces[p][i]));
                worst = std::max(worst, std::abs(forces[p][i] + (above - below) / (2 * d)));
            }
        QVERIFY(largest > 0);
        QVERIFY2(worst < 1e-6 * largest, qPrintable(QString("%1 of %2").arg(worst).arg(largest)));
    }

    /// It would drown all else in the matrix, so that nothing could be solved.
    void aHingeOfATriangleThatHasCollapsedBendsNothing() {
        auto [model, x] = caseOf("hinge");
        x[2] = x[0] + (x[1] - x[0]) * 0.3 + Vec3{1e-9, 0, 0};
        DenseSink hessian(4);
        cloth::addHessian(model, x, cloth::HessianForm::projected, hessian);
        QCOMPARE(std::ranges::max(hessian.values), 0.0);
        QCOMPARE(forcesOf(model, x), std::vector<Vec3>(4));
    }

    void hessianIsTheDerivativeOfForce_data() { kinds(); }
    void hessianIsTheDerivativeOfForce() {
        QFETCH(QString, kind);
        auto [model, x] = caseOf(kind);
        DenseSink sink(model.particleCount());
        cloth::addHessian(model, x, cloth::HessianForm::exact, sink);
        double largest = 0, worst = 0;
        constexpr double d = 1e-7;
        for (std::size_t p = 0; p < x.size(); ++p)
            for (int i = 0; i < 3; ++i) {
                const double at = x[p][i];
                x[p][i] = at + d;
                const auto above = forcesOf(model, x);
                x[p][i] = at - d;
                const auto below = forcesOf(model, x);
                x[p][i] = at;
                for (int row = 0; row < sink.n; ++row) {
                    const double h = sink.values[std::size_t(row) * sink.n + 3 * p + i];
                    const double difference = -(above[row / 3][row % 3] - below[row / 3][row % 3]) / (2 * d);
                    largest = std::max(largest, std::abs(h));
                    worst = std::max(worst, std::abs(h - difference));
                }
            }
        QVERIFY2(worst < 1e-6 * largest, qPrintable(QString("%1 of %2").arg(worst).arg(largest)));
    }

    void projectedHessianIsNowhereNegative_data() { kinds(); }
    void projectedHessianIsNowhereNegative() {
        QFETCH(QString, kind);
        auto [model, x] = caseOf(kind);
        for (Vec3& p : x) p *= 0.7; // compressed: the exact one is indefinite here
        DenseSink sink(model.particleCount());
        cloth::addHessian(model, x, cloth::HessianForm::projected, sink);
        std::mt19937 random(3);
        for (int trial = 0; trial < 200; ++trial) {
            std::vector<double> v(sink.n);
            for (double& value : v) value = double(random()) / std::mt19937::max() - 0.5;
            double form = 0, scale = 0;
            for (int i = 0; i < sink.n; ++i)
                for (int j = 0; j < sink.n; ++j) {
                    form += v[i] * sink.values[std::size_t(i) * sink.n + j] * v[j];
                    scale = std::max(scale, std::abs(sink.values[std::size_t(i) * sink.n + j]));
                }
            QVERIFY(form > -1e-10 * scale);
        }
    }

    void forcesAndTorquesOfACrumpledClothSumToZero_data() { kinds(); }
    void forcesAndTorquesOfACrumpledClothSumToZero() {
        QFETCH(QString, kind);
        auto [model, x] = caseOf(kind);
        const auto forces = forcesOf(model, x);
        Vec3 sum, torque;
        double scale = 0, torqueScale = 0;
        for (std::size_t p = 0; p < x.size(); ++p) {
            sum += forces[p];
            torque += cross(x[p], forces[p]);
            scale += length(forces[p]);
            torqueScale += length(x[p]) * length(forces[p]);
        }
        QVERIFY(length(sum) < 1e-12 * scale); // rounding of a hundred summands
        QVERIFY(length(torque) < 1e-12 * torqueScale);
    }

    void energyBelongsToTheKindOfElement() {
        const auto lines = evenLines(0.03, 3);
        const Patch patch = gridPatch(lines, lines);
        auto x = flatPositions(patch);
        shake(x, 0.002);
        const auto woven = cloth::elasticEnergy(modelOf(patch, wovenFabric()), x);
        QVERIFY(woven.springs > 0 && woven.bending > 0 && woven.membrane == 0);
        const auto knit = cloth::elasticEnergy(modelOf(patch, knitFabric()), x);
        QVERIFY(knit.springs == 0 && knit.membrane > 0);
    }

    void frequencyBoundIsAboveTheLargestRayleighQuotient() {
        const auto lines = evenLines(0.05, 5);
        for (const Fabric& fabric : {wovenFabric(), knitFabric()}) {
            const Patch patch = gridPatch(lines, lines);
            Fabric linear = fabric;
            linear.warpTension = linear.weftTension = {};
            const ClothModel model = modelOf(patch, linear);
            const auto x = flatPositions(patch);
            DenseSink sink(model.particleCount());
            cloth::addHessian(model, x, cloth::HessianForm::exact, sink);
            std::vector<double> v(sink.n, 0.0); // power iteration on M⁻¹K
            std::mt19937 random(5);
            for (double& value : v) value = double(random()) / std::mt19937::max() - 0.5;
            double frequencySquared = 0;
            for (int iteration = 0; iteration < 300; ++iteration) {
                std::vector<double> w(sink.n, 0.0);
                double norm = 0;
                for (int i = 0; i < sink.n; ++i) {
                    for (int j = 0; j < sink.n; ++j) w[i] += sink.values[std::size_t(i) * sink.n + j] * v[j];
                    w[i] /= model.mass[i / 3];
                    norm += w[i] * w[i];
                }
                frequencySquared = std::sqrt(norm);
                for (int i = 0; i < sink.n; ++i) v[i] = w[i] / frequencySquared;
            }
            const double bound = cloth::largestFrequencySquared(model);
            QVERIFY(bound >= frequencySquared * (1 - 1e-9));
            QVERIFY2(bound < 6 * frequencySquared,
                     qPrintable(QString::number(bound / frequencySquared))); // and is of use
        }
    }

    void aSpringWithoutLengthPartsItsEnds() {
        ClothModel model;
        model.mass = {1, 1};
        model.structural = {{0, 1, 0.01, 100}};
        const auto forces = forcesOf(model, {{1, 2, 3}, {1, 2, 3}});
        QVERIFY(std::abs(length(forces[0]) - 1) < 1e-12); // all of its push, in a direction of its own
        QCOMPARE(forces[0], -forces[1]);
        DenseSink sink(2);
        const std::vector<Vec3> x{{1, 2, 3}, {1, 2, 3}};
        cloth::addHessian(model, x, cloth::HessianForm::exact, sink);
        QCOMPARE(sink.values[0], 100.0);
    }
};

TOILE_TEST(tst_Forces)
#include "tst_Forces.moc"
