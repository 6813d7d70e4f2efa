// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/cloth/Patch.h"
#include "core/cloth/Strain.h"
#include "core/cloth/Tension.h"
#include "tests/Suite.h"
#include "tests/cloth/Fixtures.h"

#include <QTest>
#include <numeric>

using namespace toile;
using namespace toile::fixtures;

namespace {

cloth::PatchReport append(ClothModel& model, const Patch& patch, const Fabric& fabric,
                          cloth::CellForm form = cloth::CellForm::automatic) {
    auto report = cloth::appendPatch(model, patch, fabric, {form});
    if (!report) qFatal("%s", toString(report.error()).c_str());
    return *report;
}

/// z = ½κ(x·cos + y·sin)²: a shallow cylinder whose lines of no curvature run across the direction.
std::vector<Vec3> bent(const Patch& patch, double curvature, double angle) {
    auto x = flatPositions(patch);
    for (Vec3& p : x) p.z = 0.5 * curvature * std::pow(p.x * std::cos(angle) + p.y * std::sin(angle), 2);
    return x;
}

double bendingEnergy(const ClothModel& model, const std::vector<Vec3>& x) {
    return cloth::elasticEnergy(model, x).bending;
}

/// Equilateral triangles of side s, n × n rhombi.
Patch equilateralPatch(double s, int n) {
    Patch patch;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            patch.particles.push_back(static_cast<int>(patch.material.size()));
            patch.material.push_back({s * (i + 0.5 * j), s * j * std::sqrt(0.75)});
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i;
            patch.triangles.push_back({{a, a + 1, a + n + 1}, {}});
            patch.triangles.push_back({{a + 1, a + n + 2, a + n + 1}, {}});
        }
    return patch;
}

} // namespace

class tst_Patch : public QObject {
    Q_OBJECT

private slots:
    void massIsDensityTimesArea() {
        const std::vector<double> unequal{0, 0.01, 0.025, 0.033, 0.05};
        for (const Patch& patch : {gridPatch(unequal, evenLines(0.03, 3)), trianglePatch(unequal, evenLines(0.03, 3)),
                                   twoRegionPatch(0.05, 5, 0.01, 1, 0.03, 4)}) {
            ClothModel model;
            const auto report = append(model, patch, wovenFabric());
            const double sum = std::accumulate(model.mass.begin(), model.mass.end(), 0.0);
            QVERIFY(std::abs(sum - 0.2 * 0.05 * 0.03) < 1e-12 * sum);
            QVERIFY(std::abs(report.area - 0.05 * 0.03) < 1e-12 * report.area);
            for (const auto& slave : model.slaves) QCOMPARE(model.mass[slave.particle], 0.0);
        }
    }

    void neighboursShareOneSpring() {
        const ClothModel model = modelOf(gridPatch(evenLines(0.03, 3), evenLines(0.02, 2)), wovenFabric());
        QCOMPARE(int(model.structural.size()), 3 * 3 + 4 * 2);
        QCOMPARE(int(model.shear.size()), 2 * 6);
        QCOMPARE(int(model.twist.size()), 6);               // 4·22 − 30 − 20 > 0
        QCOMPARE(int(model.bending.size()), 2 * 3 + 4 * 1); // inner nodes of three rows and four columns
    }

    void whatTheFabricDoesNotNeedIsNotThere() {
        Fabric limp = wovenFabric();
        limp.warpBending = limp.weftBending = limp.biasBending = 0;
        limp.shearStiffness = 0;
        const ClothModel model = modelOf(gridPatch(evenLines(0.03, 3), evenLines(0.02, 2)), limp);
        QVERIFY(model.bending.empty() && model.twist.empty() && model.shear.empty() && model.cells.empty());
    }

    void aNegativeTwistIsLeftOutAndReported() {
        Fabric fabric = wovenFabric();
        fabric.biasBending = 5e-6;
        ClothModel model;
        QVERIFY(append(model, gridPatch(evenLines(0.02, 2), evenLines(0.02, 2)), fabric).twistLeftOut);
        QVERIFY(model.twist.empty());
    }

    void onePieceHasOneKindOfCell() {
        Fabric soft = wovenFabric();
        soft.weftStiffness = 100; // √(E/G) = 1.8: the cell of aspect 3 would need a negative spring
        const Patch patch = gridPatch({0, 0.01, 0.04}, evenLines(0.02, 2));
        ClothModel model;
        const auto report = append(model, patch, soft);
        QVERIFY(report.membraneCells);
        QCOMPARE(report.clampedCells, 0);
        QVERIFY(model.structural.empty() && model.shear.empty());
        QCOMPARE(int(model.cells.size()), 4);

        ClothModel paper;
        QCOMPARE(append(paper, patch, soft, cloth::CellForm::springs).clampedCells, 2);
        QCOMPARE(paper.clampedCells, 2);
        for (const auto& spring : paper.structural) QVERIFY(spring.stiffness >= 0);
    }

    void aFabricWithTooMuchShearIsRefusedByName() {
        Fabric fabric = wovenFabric();
        fabric.warpStiffness = 0;
        ClothModel model;
        const auto report = cloth::appendPatch(model, gridPatch(evenLines(0.02, 2), evenLines(0.02, 2)), fabric,
                                               {cloth::CellForm::springs});
        QVERIFY(!report);
        QVERIFY(report.error().place.object.find("test weave") != std::string::npos);
    }

    void aRegionIsStifferByItsFactors() {
        Patch patch = gridPatch(evenLines(0.03, 3), evenLines(0.03, 3));
        auto x = flatPositions(patch);
        shake(x, 0.002);
        const auto plain = cloth::elasticEnergy(modelOf(patch, wovenFabric()), x);
        for (auto& cell : patch.rectangles) cell.factors = {.stretch = 3, .shear = 3, .bending = 5};
        const auto stiff = cloth::elasticEnergy(modelOf(patch, wovenFabric()), x);
        QVERIFY(std::abs(stiff.springs - 3 * plain.springs) < 1e-9 * stiff.springs);
        QVERIFY(std::abs(stiff.bending - 5 * plain.bending) < 1e-9 * stiff.bending);
    }

    void aCylinderStoresItsBendingEnergyInRowsOfAnyHeight() {
        Fabric fabric = wovenFabric();
        fabric.biasBending = (fabric.warpBending + fabric.weftBending) / 4; // no twist
        const std::vector<double> unequal{0, 0.01, 0.025, 0.033, 0.05};
        const Patch patch = gridPatch(unequal, evenLines(0.04, 4));
        // Along weft: the curvature is exact at inner nodes, half a cell at either end has none.
        const double inner = (0.05 - 0.5 * (0.01 + 0.017)) * 0.04;
        const double expected = 0.5 * fabric.weftBending * 0.1 * 0.1 * inner;
        QVERIFY(std::abs(bendingEnergy(modelOf(patch, fabric), bent(patch, 0.1, 0)) - expected) < 1e-9 * expected);
    }

    void bendingCrossesARegionJoint_data() {
        QTest::addColumn<int>("ratio");
        QTest::newRow("1 : 2") << 2;
        QTest::newRow("1 : 4") << 4;
    }
    void bendingCrossesARegionJoint() {
        QFETCH(int, ratio);
        Fabric fabric = wovenFabric();
        fabric.biasBending = (fabric.warpBending + fabric.weftBending) / 4;
        const double h = 0.01 / ratio;
        const Patch patch = twoRegionPatch(0.04, 4, 0.02, 2, 0.04, 2 * ratio, ratio);
        // Along warp every line, whole or of slaves, sees the curvature up to half a cell from the ends.
        const double inner = (0.04 - 0.5 * (0.01 + h)) * 0.04;
        const double expected = 0.5 * fabric.warpBending * 0.1 * 0.1 * inner;
        const double measured = bendingEnergy(modelOf(patch, fabric), bent(patch, 0.1, std::numbers::pi / 2));
        QVERIFY2(std::abs(measured - expected) < 1e-9 * expected,
                 qPrintable(QString("%1 of %2").arg(measured).arg(expected)));
    }

    void rigidMotionsBendNothing() {
        for (const Patch& patch : {gridPatch(evenLines(0.03, 3), evenLines(0.02, 2)), equilateralPatch(0.01, 4),
                                   twoRegionPatch(0.05, 5, 0.01, 1, 0.03, 4)}) {
            const ClothModel model = modelOf(patch, wovenFabric());
            auto x = flatPositions(patch);
            for (Vec3& p : x) p = {0.6 * p.x + 0.8 * p.y + 3, 0.2 - 0.8 * p.x + 0.6 * p.y, 1.0};
            QVERIFY(cloth::energy(model, x) < 1e-20); // rounding of 1 m in 1e-16, squared, times k/h²
        }
    }

    void equilateralTrianglesBendAlikeInEveryDirection() {
        Fabric fabric = wovenFabric();
        fabric.warpBending = fabric.weftBending = fabric.biasBending = 20e-6;
        const int n = 40;
        const double s = 0.005, area = n * n * s * s * std::sqrt(0.75);
        const Patch patch = equilateralPatch(s, n);
        const ClothModel model = modelOf(patch, fabric);
        const double expected = 0.5 * 20e-6 * 0.1 * 0.1 * area;
        for (double degrees : {0, 15, 30, 45, 60, 90, 120}) {
            const double measured = bendingEnergy(model, bent(patch, 0.1, degrees * std::numbers::pi / 180));
            QVERIFY(std::abs(measured - expected) < 0.06 * expected); // border edges have no second triangle: about 2/n
        }
    }

    void aCylinderBendsAcrossFromRectanglesToTriangles() {
        Fabric fabric = wovenFabric();
        fabric.biasBending = (fabric.warpBending + fabric.weftBending) / 4;
        Patch patch = gridPatch(evenLines(0.06, 6), evenLines(0.04, 4));
        std::vector<cloth::PatchRectangle> kept;
        for (const auto& cell : patch.rectangles) {
            if (patch.material[cell.nodes[0]].x < 0.0299) {
                kept.push_back(cell);
                continue;
            }
            patch.triangles.push_back({{cell.nodes[0], cell.nodes[1], cell.nodes[2]}, {}});
            patch.triangles.push_back({{cell.nodes[0], cell.nodes[2], cell.nodes[3]}, {}});
        }
        patch.rectangles = kept;
        const double expected = 0.5 * fabric.weftBending * 0.1 * 0.1 * 0.05 * 0.04; // half a cell less at both ends
        const double measured = bendingEnergy(modelOf(patch, fabric), bent(patch, 0.1, 0));
        QVERIFY(std::abs(measured - expected) < 1e-9 * expected);
    }

    /// The height of a wave cos(pi)·cos(qj) over nodes i, j is pulled back, wherever it is not near the border, as that
    /// of a plate is: by B2·P² + B1·Q² + (4·B45 − B1 − B2)·P·Q, P = (2/a·sin(p/2))² and Q = (2/b·sin(q/2))². That is 0
    /// for p = q = 0 only: zigzags of two rows and chequers of two cells are bent as hard as they look.
    void noRippleOfTheMeshIsFree() {
        const double a = 0.01, b = 0.013;
        const int n = 9;
        const Patch patch = gridPatch(evenLines(n * a, n), evenLines(n * b, n));
        const Fabric fabric = wovenFabric();
        const ClothModel model = modelOf(patch, fabric);
        const int node = 4 * (n + 1) + 4; // two cells from every border
        for (const double p : {0.0, 1.0, 2.0, std::numbers::pi})
            for (const double q : {0.0, 1.0, 2.0, std::numbers::pi}) {
                if (p == 0 && q == 0) continue;
                auto x = flatPositions(patch);
                for (std::size_t i = 0; i < x.size(); ++i)
                    x[i].z = 1e-9 * std::cos(p * (double(i % (n + 1)) - 4)) * std::cos(q * (double(i / (n + 1)) - 4));
                std::vector<Vec3> forces(x.size());
                cloth::addForces(model, x, forces);
                const double P = 4 / (a * a) * std::pow(std::sin(p / 2), 2),
                             Q = 4 / (b * b) * std::pow(std::sin(q / 2), 2);
                const double twist = 4 * fabric.biasBending - fabric.warpBending - fabric.weftBending;
                const double stiffness = fabric.weftBending * P * P + fabric.warpBending * Q * Q + twist * P * Q;
                const double expected = -a * b * stiffness * 1e-9;
                QVERIFY2(
                    std::abs(forces[node].z - expected) < 1e-6 * std::abs(expected),
                    qPrintable(QString("p %1 q %2: %3 N, not %4").arg(p).arg(q).arg(forces[node].z).arg(expected)));
            }
    }

    void aSeamHingeIsAsStiffAsARowOfRectangles() {
        const cloth::SeamEdge edge{.particles = {0, 1, 2, 3},
                                   .length = 0.01,
                                   .heightC = 0.02,
                                   .heightD = 0.03,
                                   .bending = 20e-6,
                                   .restAngle = 0};
        ClothModel model;
        model.hinges = {cloth::seamHinge(edge)};
        const double angle = 0.01, half = angle / 2;
        const std::vector<Vec3> x{{0, 0, 0},
                                  {0, 0.01, 0},
                                  {-0.02 * std::cos(half), 0.005, 0.02 * std::sin(half)},
                                  {0.03 * std::cos(half), 0.005, 0.03 * std::sin(half)}};
        // ½·B·width·(l₁ + l₂)/2·κ² with κ = 2θ/(l₁ + l₂); lifting both sides closes the right side: θ > 0
        const double expected = 0.5 * 20e-6 * 0.01 * 0.025 * std::pow(angle / 0.025, 2);
        model.mass.assign(4, 1);
        QVERIFY(std::abs(cloth::energy(model, x) - expected) < 1e-9 * expected);
        model.hinges[0].restAngle = angle;
        QVERIFY(cloth::energy(model, x) < 1e-9 * expected);
    }

    void clampedRowsAreTwiceAsStiff() {
        ClothModel model = modelOf(gridPatch(evenLines(0.05, 5), evenLines(0.01, 1)), wovenFabric());
        const ClothModel before = model;
        model.pinned = {0, 1, 6, 7}; // two columns
        cloth::doubleBendingAtClampedRows(model);
        int doubled = 0;
        for (std::size_t i = 0; i < model.bending.size(); ++i)
            doubled += model.bending[i].stiffness == 2 * before.bending[i].stiffness;
        QCOMPARE(doubled, 2);
    }

    void nodesSewnTogetherAreOneParticle() {
        // A strip closed to a ring: the nodes of its last column are those of the first.
        Patch patch = gridPatch(evenLines(0.06, 6), evenLines(0.02, 2));
        for (int row = 0; row < 3; ++row) patch.particles[row * 7 + 6] = patch.particles[row * 7];
        ClothModel model = modelOf(patch, wovenFabric());
        const double sum = std::accumulate(model.mass.begin(), model.mass.end(), 0.0);
        QVERIFY(std::abs(sum - 0.2 * 0.06 * 0.02) < 1e-12 * sum);
        QVERIFY(std::abs(model.mass[7] - 0.2 * 0.01 * 0.01) < 1e-15); // a whole cell now
        QCOMPARE(int(model.structural.size()), 3 * 6 + 7 * 2); // both sides of the seam keep their own warp springs
        for (const auto& spring : model.structural) QVERIFY(spring.a != spring.b);
    }

    void mastersThatWereSewnTogetherAddTheirWeights() {
        Patch patch = twoRegionPatch(0.04, 2, 0.02, 1, 0.04, 2);
        const auto slave = patch.slaves.front();
        patch.particles[slave.masters[1].first] = patch.particles[slave.masters[0].first];
        const ClothModel model = modelOf(patch, wovenFabric());
        QCOMPARE(int(model.slaves.front().masters.size()), 1);
        QCOMPARE(model.slaves.front().masters.front().second, 1.0);
    }

    void tensionCurvesStiffenAndAreContinuous() {
        const std::vector<material::TensionPoint> curve{{0.1, 2}, {0.2, 5}};
        QCOMPARE(cloth::tensionResponse(curve, 0.1).stress, 0.2);
        QCOMPARE(cloth::tensionResponse(curve, 0.2).stress, 1.0);
        QCOMPARE(cloth::tensionResponse(curve, -0.1).stress, -0.1);
        QVERIFY(std::abs(cloth::tensionResponse(curve, 1e-6).stress - 1e-6) < 2e-11); // modulus 1 at rest
        for (double e = -0.05; e < 0.4; e += 0.0173) {
            const auto response = cloth::tensionResponse(curve, e);
            QVERIFY(std::abs(cloth::tensionSecant(curve, e) * e - response.stress) <=
                    1e-14 * std::abs(response.stress));
            constexpr double d = 1e-6;
            const auto above = cloth::tensionResponse(curve, e + d), below = cloth::tensionResponse(curve, e - d);
            QVERIFY(std::abs((above.energy - below.energy) / (2 * d) - response.stress) < 1e-9);
            QVERIFY(std::abs((above.stress - below.stress) / (2 * d) - response.tangent) < 1e-4);
        }
    }

    void strainsReportWhatWasDone() {
        for (const Patch& patch : {gridPatch(evenLines(0.03, 3), evenLines(0.02, 2)),
                                   trianglePatch(evenLines(0.03, 3), evenLines(0.02, 2))}) {
            auto x = flatPositions(patch);
            for (Vec3& p : x) p = {1.02 * p.x + 0.97 * std::sin(0.1) * p.y, 0.97 * std::cos(0.1) * p.y, 0};
            double area = 0;
            for (const auto& strain : cloth::strains(patch, x)) {
                QVERIFY(std::abs(strain.weft - 0.02) < 1e-12);
                QVERIFY(std::abs(strain.warp + 0.03) < 1e-12);
                QVERIFY(std::abs(strain.shear - 0.1) < 1e-12);
                area += strain.area;
            }
            QVERIFY(std::abs(area - 0.03 * 0.02) < 1e-15);
        }
        QCOMPARE(cloth::areaPercentile({{3, 1}, {1, 98}, {2, 1}}, 0.99), 2.0);
    }
};

TOILE_TEST(tst_Patch)
#include "tst_Patch.moc"
