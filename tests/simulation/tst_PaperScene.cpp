// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

Scene paperScene() {
    Scene scene = twoSquares();
    scene.paper = true;
    return scene;
}

} // namespace

/// A scene of the 2002 paper: what it is made of, and that it sews.
class tst_PaperScene : public QObject {
    Q_OBJECT

private slots:
    void itIsMadeOfSpringsAlone() {
        const Simulation simulation = simulationOf(paperScene());
        const cloth::ClothModel& model = simulation.garment().model;
        QVERIFY(!model.structural.empty() && !model.shear.empty() && !model.flexion.empty());
        QVERIFY(model.bending.empty() && model.twist.empty() && model.hinges.empty() && model.triangles.empty());
        QVERIFY(simulation.garment().paper && simulation.garment().paper->flexionSprings > 0);
        for (const char* stage : {"bending", "seam hinges", "self-contact"})
            QVERIFY(std::ranges::any_of(simulation.plan().leftOut(),
                                        [&](const LeftOut& left) { return left.stage == stage; }));
    }

    void knitsAreSpringsToo() {
        Scene scene = paperScene();
        material::Fabric fabric = *scene.pattern.fabrics.front();
        fabric.kind = material::FabricKind::knit;
        fabric.weftStiffness = 0.1 * fabric.warpStiffness; // and so much shear that the diagonals alone are stiffer
        fabric.shearStiffness = 2 * fabric.warpStiffness;
        scene.pattern.fabrics.front() = fabric;
        const Simulation simulation = simulationOf(scene);
        QVERIFY(simulation.garment().model.cells.empty());
        QVERIFY(simulation.garment().model.clampedCells > 0);
    }

    void theForceSewsWithExplicitSteps() {
        Simulation simulation = simulationOf(paperScene());
        const auto report = sew(simulation, {});
        QVERIFY(report);
        QVERIFY(report->allClosed() && report->atRest);
        QVERIFY(report->residual && std::isfinite(*report->residual));
        QVERIFY(!report->finishDisplacementMaximum); // there is no finish
        for (const SeamResult& seam : report->seams) QVERIFY(seam.state.gapAtMerge <= 0.5e-3);
        for (const PhaseRun& phase : report->phases) QVERIFY(phase.method == "subcycled-euler");
        QVERIFY(report->paper);
    }

    void anotherSceneKnowsNothingOfIt() {
        Simulation simulation = simulationOf(twoSquares());
        QVERIFY(!simulation.garment().paper && simulation.garment().model.flexion.empty());
    }
};

TOILE_TEST(tst_PaperScene, QCoreApplication)
#include "tst_PaperScene.moc"
