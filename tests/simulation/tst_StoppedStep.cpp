// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/SceneCheck.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>
#include <thread>

using namespace toile;
using namespace toile::simulation;
using dynamics::Method;

namespace {

void goOn(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i)
        if (!simulation.advance()) qFatal("a step failed");
}

/// A sheet that has begun to lie on the table, with contact and friction.
Simulation fallen(Method method) {
    Simulation simulation = simulationOf(sheetOnTable(0.51));
    simulation.drapeWith(method);
    goOn(simulation, 12);
    return simulation;
}

} // namespace

/// A frame step that is stopped has not been.
class tst_StoppedStep : public QObject {
    Q_OBJECT
private slots:
    void whatFollowsIsAsFromACheckpoint_data() {
        QTest::addColumn<Method>("method");
        for (const Method method : {Method::xpbd, Method::trBdf2})
            QTest::newRow(std::string(dynamics::nameOf(method)).c_str()) << method;
    }
    void whatFollowsIsAsFromACheckpoint() {
        QFETCH(Method, method);
        Simulation stopped = fallen(method), asked = fallen(method);
        std::stop_source stop;
        stop.request_stop();
        const auto refused = stopped.advance(stop.get_token());
        QVERIFY(!refused && refused.error().code == ErrorCode::cancelled);
        (void)asked.checkpoint(); // lets go of what is only remembered
        QVERIFY(stopped.state().positions == asked.state().positions);
        QCOMPARE(stopped.steps(), asked.steps());
        goOn(stopped, 5);
        goOn(asked, 5);
        QVERIFY(stopped.state().positions == asked.state().positions);
        QVERIFY(stopped.state().velocities == asked.state().velocities);
    }

    /// Wherever in the step the stop comes.
    void itStopsWithinTheStep() {
        Scene scene = twoSquares(0.005); // so many substeps take seconds
        scene.pattern.seams.clear();
        scene.settings.substeps = mostSubsteps;
        Simulation simulation = simulationOf(scene);
        const std::vector<Vec3> before = simulation.state().positions;
        std::stop_source stop;
        const std::jthread asks([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
            stop.request_stop();
        });
        const auto refused = simulation.advance(stop.get_token());
        QVERIFY(!refused && refused.error().code == ErrorCode::cancelled);
        QVERIFY(simulation.state().positions == before);
        QCOMPARE(simulation.state().time, 0.0);
        QCOMPARE(simulation.steps(), 0);
    }
};

TOILE_TEST(tst_StoppedStep, QCoreApplication)
#include "tst_StoppedStep.moc"
