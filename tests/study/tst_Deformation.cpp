// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Sew.h"
#include "core/study/Deformation.h"
#include "samples/SmallScenes.h"
#include "tests/Suite.h"

#include <QTest>
#include <cmath>

using namespace toile;

namespace {

/// A flat sheet of 0.4 m, half of it a finer region.
simulation::Scene halfFineSheet() {
    const auto document = samples::squareSheet(samples::SheetPins::oneEdge, 0.4, 0.02);
    simulation::Scene scene{document.pattern, {}, document.scene};
    pattern::Piece piece = *scene.pattern.pieces[0];
    pattern::Region half;
    half.id = pattern::RegionId{"half"};
    half.name = "half";
    half.outline = {{{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0}, {-0.3, 0}}};
    half.refinement = 1;
    piece.regions = {half};
    scene.pattern.pieces[0] = Shared<pattern::Piece>(std::move(piece));
    return scene;
}

} // namespace

class tst_Deformation : public QObject {
    Q_OBJECT
private slots:
    void aSheetThatStartsFlatIsNotDeformed();
    void aTubeIsStretchedAndCurvedByItsCylinder();
    void thePartsSayWhetherTheRegionsLieRight();
};

void tst_Deformation::aSheetThatStartsFlatIsNotDeformed() {
    const auto simulation = simulation::Simulation::create(halfFineSheet());
    QVERIFY(simulation);
    double area = 0;
    for (const auto& part : study::deformationOf(*simulation, simulation->scene().pattern)) {
        QVERIFY(part.energy() < 1e-12);
        area += part.area;
    }
    QVERIFY(std::abs(area - 0.16) < 1e-9);
}

/// Cloth drawn over a cylinder is stretched round it, and curved with it in one of two directions.
void tst_Deformation::aTubeIsStretchedAndCurvedByItsCylinder() {
    const samples::TubeScene tube{.spacing = 0.01};
    const auto document = samples::tubeRoundCylinder(tube);
    body::Body cylinder{"cylinder", samples::cylinderMesh(), {}, {}};
    auto simulation =
        simulation::Simulation::create({document.pattern, Shared<body::Body>(std::move(cylinder)), document.scene});
    QVERIFY(simulation);
    QVERIFY(simulation::sew(*simulation, {}));
    const auto parts = study::deformationOf(*simulation, document.pattern);
    QCOMPARE(static_cast<int>(parts.size()), 1);
    const Vec3& p = simulation->state().positions.front();
    const double radius = std::hypot(p.x, p.z), strain = radius / tube.restRadius - 1;
    const auto isNear = [](double value, double expected) { return std::abs(value / expected - 1) < 0.03; };
    QVERIFY(isNear(parts[0].strainRms, strain / std::sqrt(2)));
    QVERIFY(isNear(parts[0].stretchEnergy, tube.stiffness * strain * strain / 2));
    // Second derivatives are over material lengths, which the hoop has stretched.
    QVERIFY(isNear(parts[0].curvatureRms, (1 + strain) * (1 + strain) / radius / std::sqrt(2)));
}

void tst_Deformation::thePartsSayWhetherTheRegionsLieRight() {
    const study::PartDeformation finer{.piece = "a", .region = "b", .finer = true, .area = 1, .bendingEnergy = 4e-3},
        rest{.piece = "a", .area = 3, .stretchEnergy = 1e-3, .bendingEnergy = 2e-3};
    study::PartDeformation still = finer;
    still.bendingEnergy = 1e-3;
    QVERIFY(study::deformationText({still, rest}).find("deforms less there than elsewhere.") != std::string::npos);
    const std::string text = study::deformationText({finer, rest});
    QVERIFY(text.find("2 times the bending energy") != std::string::npos);
    QVERIFY(text.find("The regions lie where the cloth deforms more.") != std::string::npos);
    QVERIFY(study::deformationText({rest}).find("finer") == std::string::npos); // nothing to compare
}

TOILE_TEST(tst_Deformation)
#include "tst_Deformation.moc"
