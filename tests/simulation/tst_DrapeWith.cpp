// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;
using dynamics::Method;

namespace {

SewReport sewnBy(std::optional<Method> method, const SewSettings& settings = {}) {
    Simulation simulation = simulationOf(twoSquares(0.05));
    simulation.drapeWith(method);
    return sewn(simulation, settings);
}

} // namespace

/// Methods other than XPBD in a run that also sews.
class tst_DrapeWith : public QObject {
    Q_OBJECT

private slots:
    void sewingIsPositionBasedAndCalmedBeforeAnotherMethodTakesOver() {
        const SewReport report = sewnBy(Method::trBdf2);
        QVERIFY(report.allClosed() && report.atRest);
        QCOMPARE(report.phases.size(), std::size_t(4));
        const std::pair<Phase, std::string_view> expected[] = {{Phase::sewing, "xpbd"},
                                                               {Phase::shaking, "backward-euler"},
                                                               {Phase::shaking, "trbdf2"},
                                                               {Phase::draping, "trbdf2"}};
        for (int i = 0; i < 4; ++i) {
            QVERIFY(report.phases[i].phase == expected[i].first);
            QVERIFY(report.phases[i].method == expected[i].second);
        }
        QCOMPARE(report.phases[1].seconds, 2.0 / 60);
    }

    void withoutCallingItAllPhasesAreXpbd() {
        Simulation simulation = simulationOf(twoSquares(0.05));
        const auto report = sew(simulation, {});
        QVERIFY(report);
        for (const PhaseRun& phase : report->phases) QVERIFY(phase.method == "xpbd");
    }

    void staticsFollowsSewingAtOnce() {
        const SewReport report = sewnBy(std::nullopt);
        QVERIFY(report.allClosed() && report.atRest);
        QCOMPARE(report.phases.size(), std::size_t(1));
        QVERIFY(report.phases[0].phase == Phase::sewing);
        QVERIFY(report.finishDisplacementMaximum.has_value());
        QVERIFY(!report.restWallSeconds);
    }

    void aSceneWithoutSeamsHasNothingToCalm() {
        Scene scene = twoSquares(0.05);
        scene.pattern.seams.clear();
        Simulation simulation = simulationOf(scene);
        simulation.drapeWith(Method::bdf2);
        QVERIFY(simulation.advance());
        QCOMPARE(simulation.phases().size(), std::size_t(1));
        QVERIFY(simulation.phases()[0].method == "bdf2");
    }

    void everyMethodFindsTheSameEquilibrium() {
        // Two squares in the void: flat and side by side again, wherever they drifted.
        for (const Method method : {Method::trBdf2, Method::backwardEuler, Method::symplecticEuler}) {
            const SewReport report = sewnBy(method);
            QVERIFY(report.atRest);
            QVERIFY(report.elasticEnergy < 1e-6 && report.strain.rms < 1e-3);
        }
    }

    void anExplicitMethodIsStableAtTheTrueStiffness() {
        const SewReport report = sewnBy(Method::symplecticEuler, {.seconds = 2.0});
        QVERIFY(report.phases.back().steps.parts > 100); // divided by its limit
        QVERIFY(report.elasticEnergy < 1e-3);
    }
};

TOILE_TEST(tst_DrapeWith)
#include "tst_DrapeWith.moc"
