// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Warnings.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"
#include "tests/simulation/SmallScenes.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

/// Frame steps until the cloth sleeps.
int stepsToSleep(Simulation& simulation) {
    constexpr int most = 1200;
    int steps = 0;
    for (; steps < most && simulation.sleptTime() == 0; ++steps)
        if (!simulation.advance()) qFatal("the sheet cannot be advanced");
    return steps;
}

void advance(Simulation& simulation, int steps) {
    for (int i = 0; i < steps; ++i)
        if (!simulation.advance()) qFatal("the sheet cannot be advanced");
}

double farthestBetween(const Simulation& a, const Simulation& b) {
    double most = 0;
    for (std::size_t p = 0; p < a.state().positions.size(); ++p)
        most = std::max(most, geometry::distance(a.state().positions[p], b.state().positions[p]));
    return most;
}

Grip cornerHeldAt(const Vec3& target) {
    return {.piece = "sheet", .material = {0, 0}, .target = target};
}

std::string whyNotWatched(const Simulation& simulation) {
    for (const LeftOut& left : simulation.plan().leftOut())
        if (left.stage == "energy watch") return left.why;
    return "";
}

} // namespace

/// Cloth that nothing drives: it sleeps when it lies still, and its energy is watched.
class tst_Still : public QObject {
    Q_OBJECT
private slots:
    void whatLiesStillSleeps();
    void itWouldHaveLainThereAnyway();
    void aHandWakesIt();
    void aStopIsHeardInSleep();
    void aCheckpointGoesOnToTheSameBits();
    void whatDrivesClothIsNamedWhereEnergyIsNotWatched();
    void clothThatIsPushedOutOfABodyIsToldOf();
    void clothThatFallsIsNot();
    void clothThatFallsAsFastAsItMayIsToldOf();
};

void tst_Still::whatLiesStillSleeps() {
    Simulation simulation = simulationOf(sheetOnTable());
    const int steps = stepsToSleep(simulation);
    QVERIFY2(steps > 60 && steps < 600, qPrintable(QString::number(steps)));
    const std::vector<Vec3> before = simulation.state().positions;
    const auto costs = simulation.stageCosts();
    const double time = simulation.state().time, saved = simulation.savedBySleep();
    QVERIFY(saved > 0);
    advance(simulation, 30);
    QCOMPARE(simulation.state().positions, before);
    QVERIFY(std::abs(simulation.state().time - time - 0.5) < 1e-9);
    QVERIFY(std::abs(simulation.sleptTime() - 31.0 / 60) < 1e-9);
    QCOMPARE(simulation.stageCosts().front().seconds, costs.front().seconds); // no stage was run
    QVERIFY(std::abs(simulation.savedBySleep() - 31 * saved) < 1e-9);         // each as long as the others
    QCOMPARE(simulation.steps(), steps + 30);
    QVERIFY(simulation.frame().atRest);
}

void tst_Still::itWouldHaveLainThereAnyway() {
    Simulation sleeps = simulationOf(sheetOnTable()), wakes = simulationOf(sheetOnTable());
    const int steps = stepsToSleep(sleeps);
    advance(wakes, steps);
    QCOMPARE(farthestBetween(sleeps, wakes), 0.0);
    for (int second = 0; second < 10; ++second) {
        advance(sleeps, 60);
        wakes.force({});
        advance(wakes, 60);
    }
    QVERIFY(sleeps.sleptTime() > 10);
    QVERIFY(wakes.sleptTime() < 1);
    QVERIFY(farthestBetween(sleeps, wakes) < 1e-3);
}

void tst_Still::aHandWakesIt() {
    Simulation simulation = simulationOf(sheetOnTable());
    stepsToSleep(simulation);
    const double slept = simulation.sleptTime();
    const std::vector<Vec3> before = simulation.state().positions;
    simulation.hold({cornerHeldAt({-0.1, 0.7, 0.1})});
    advance(simulation, 30);
    QCOMPARE(simulation.sleptTime(), slept);
    QVERIFY(geometry::distance(simulation.state().positions.front(), before.front()) > 0.01);
}

void tst_Still::aStopIsHeardInSleep() {
    Simulation simulation = simulationOf(sheetOnTable());
    (void)stepsToSleep(simulation);
    const double time = simulation.state().time;
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = simulation.advance(stop.get_token());
    QVERIFY(!stopped && stopped.error().code == ErrorCode::cancelled);
    QCOMPARE(simulation.state().time, time);
}

void tst_Still::aCheckpointGoesOnToTheSameBits() {
    const Scene scene = sheetOnTable();
    Simulation simulation = simulationOf(scene);
    stepsToSleep(simulation);
    const Checkpoint point = simulation.checkpoint();
    auto resumed = Simulation::resumed(scene, {}, point);
    QVERIFY(resumed);
    const double slept = simulation.sleptTime();
    advance(simulation, 90);
    advance(*resumed, 90);
    QCOMPARE(resumed->state().positions, simulation.state().positions);
    QVERIFY(resumed->sleptTime() > 0.4); // after another second
    QVERIFY(std::abs(simulation.sleptTime() - slept - resumed->sleptTime()) < 1e-9);
}

void tst_Still::whatDrivesClothIsNamedWhereEnergyIsNotWatched() {
    QCOMPARE(whyNotWatched(simulationOf(twoSquares(0.05))), "seams do work");
    Scene scene = sheetOnTable();
    QCOMPARE(whyNotWatched(simulationOf(scene)), "");
    Simulation held = simulationOf(scene);
    held.hold({cornerHeldAt({0, 1, 0})});
    QCOMPARE(whyNotWatched(held), "hands do work");
    held.drapeWith(std::nullopt);
    QCOMPARE(whyNotWatched(held), "nothing moves");
    scene.settings.air = Air{};
    QCOMPARE(whyNotWatched(simulationOf(scene)), "the air does work");
}

void tst_Still::clothThatIsPushedOutOfABodyIsToldOf() {
    const SewReport report = sewn(sheetOnTable(0.48), {.seconds = 0.5});
    QCOMPARE(report.phases.size(), std::size_t(1));
    QVERIFY(report.phases.front().steps.repeated > 0);
    QVERIFY(report.phases.front().unsolvedSteps > 0);
    QVERIFY(std::ranges::any_of(report.warnings, [](const Warning& warning) {
        return warning.text.find("gained energy that nothing gave them") != std::string::npos;
    }));
}

/// 5 m in a second are 10 m/s.
void tst_Still::clothThatFallsAsFastAsItMayIsToldOf() {
    Scene scene = sheetOnTable(9);
    scene.settings.damping = 0;
    Simulation simulation = simulationOf(scene);
    const auto said = [&] {
        for (const Warning& warning : warningsOf(simulation, {}))
            if (warning.text.find("10 m/s") != std::string::npos) return true;
        return false;
    };
    advance(simulation, 58);
    QVERIFY(!said());
    advance(simulation, 8);
    QVERIFY(said());
}

void tst_Still::clothThatFallsIsNot() {
    const SewReport report = sewn(sheetOnTable(1), {.seconds = 1});
    QCOMPARE(report.phases.front().steps.repeated, 0);
    QCOMPARE(report.phases.front().unsolvedSteps, 0);
}

TOILE_TEST(tst_Still)
#include "tst_Still.moc"
