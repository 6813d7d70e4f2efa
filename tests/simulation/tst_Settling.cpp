// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Checkpoint.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"
#include "tests/simulation/SmallScenes.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

Scene fallingSquares() {
    Scene scene = twoSquares(0.05);
    scene.settings.gravity = {0, -9.81, 0};
    return scene;
}

/// How long it is shaken [s].
double shakenFor(const Scene& scene) {
    Simulation simulation = simulationOf(scene);
    while (simulation.phase() != Phase::draping && simulation.state().time < 6) run(simulation, 1);
    double seconds = 0;
    for (const PhaseRun& phase : simulation.phases())
        if (phase.phase == Phase::shaking) seconds += phase.seconds;
    return seconds;
}

/// Of the cloth as a whole [m/s].
double speedOf(const Simulation& simulation) {
    Vec3 momentum;
    double all = 0;
    const auto& mass = simulation.garment().model.mass;
    for (std::size_t p = 0; p < mass.size(); ++p) {
        momentum += simulation.state().velocities[p] * mass[p];
        all += mass[p];
    }
    return length(momentum) / all;
}

/// What rests and still moves a little, all of it alike.
Simulation driftingAtRest(const Scene& scene, double speed, dynamics::Method method = dynamics::Method::xpbd) {
    Simulation simulation = simulationOf(scene);
    while (!simulation.frame().atRest) run(simulation, 1);
    Checkpoint point = simulation.checkpoint();
    std::ranges::fill(point.velocities, Vec3{speed, 0, 0});
    auto drifting = Simulation::resumed(scene, {}, point);
    if (!drifting) qFatal("%s", toString(drifting.error()).c_str());
    drifting->drapeWith(method);
    return std::move(*drifting);
}

/// What rested, for so long [s] after something has begun to pull it steadily [m/s²].
Simulation slidingFor(double seconds, double pull) {
    Scene scene = twoSquares(0.05);
    Simulation resting = simulationOf(scene);
    while (!resting.frame().atRest) run(resting, 1);
    scene.settings.gravity = {0, -pull, 0};
    Checkpoint point = resting.checkpoint();
    point.scene = fingerprintOf(scene, resting.garment());
    auto sliding = Simulation::resumed(scene, {}, point);
    if (!sliding) qFatal("%s", toString(sliding.error()).c_str());
    run(*sliding, static_cast<int>(60 * seconds));
    return std::move(*sliding);
}

/// Of cloth that falls through air as thick as the damping of what settles [m/s].
constexpr double settlingSpeed = 9.81 / dressing.settlingDamping;
/// And of what is let go.
constexpr double releaseSpeed = 9.81 / dressing.releaseDamping;
/// Of cloth that counts as resting [m/s].
constexpr double driftSpeed = 0.004;
/// So that the squares have coarse levels [m].
constexpr double fineSpacing = 0.0025;

} // namespace

/// What was sewn finds its place without swinging, and then moves as its scene has it.
class tst_Settling : public QObject {
    Q_OBJECT
private slots:
    void whatIsCalmIsNotShakenOn();
    void whatFallsIsShakenAsLongAsMayBe();
    void itIsDampedUntilItHasSlowedDown();
    void whatMovesAgainBeforeItRestsIsDampedAgain();
    void whatHasSlowedDownKeepsItsPlan();
    void whatIsLetGoDoesNotLeap();
    void whatIsRefinedDoesNotLeap();
    void inWindItIsNotForEver();
    void onceItHasLainItIsNot();
    void whatRestsIsDampedUntilItSleeps();
    void whatSlidesDoesNotSleep();
    void whatSlidesFasterThanRestIsNotDamped();
    void atRestByAnAccurateMethodItIsNot();
    void whatWasNotSewnIsNot();
};

void tst_Settling::whatIsCalmIsNotShakenOn() {
    const double seconds = shakenFor(twoSquares(0.05));
    QVERIFY2(seconds >= dressing.leastShaking && seconds < dressing.leastShaking + 0.1,
             qPrintable(QString::number(seconds)));
}

void tst_Settling::whatFallsIsShakenAsLongAsMayBe() {
    const double seconds = shakenFor(fallingSquares());
    QVERIFY2(seconds >= dressing.shakingTime && seconds < dressing.shakingTime + 0.05,
             qPrintable(QString::number(seconds)));
}

void tst_Settling::itIsDampedUntilItHasSlowedDown() {
    Simulation simulation = simulationOf(fallingSquares());
    while (simulation.phase() != Phase::draping) run(simulation, 1);
    run(simulation, 60 + 60 * static_cast<int>(dressing.settlingTime));
    QVERIFY2(std::abs(speedOf(simulation) - settlingSpeed) < 0.02, qPrintable(QString::number(speedOf(simulation))));
}

void tst_Settling::whatMovesAgainBeforeItRestsIsDampedAgain() {
    Simulation simulation = simulationOf(twoSquares(0.05));
    while (simulation.restingTime() < 0.1) run(simulation, 1);
    QVERIFY(!simulation.frame().atRest);
    simulation.hold({{.piece = "left", .material = {0.1, 0.1}, .target = {-0.1, 2, 0}}});
    run(simulation, 10);
    simulation.hold({});
    const double before = speedOf(simulation);
    run(simulation, 12);
    const double expected = before * std::exp(-0.2 * dressing.settlingDamping);
    QVERIFY2(before > 0.1 && std::abs(speedOf(simulation) - expected) < 0.05 * before,
             qPrintable(QString("%1, then %2 m/s").arg(before).arg(speedOf(simulation))));
}

/// A new one has forgotten what layers and coarse levels bore.
void tst_Settling::whatHasSlowedDownKeepsItsPlan() {
    Scene scene = twoSquares(0.05);
    scene.settings.selfContact = true;
    Simulation simulation = simulationOf(scene);
    while (simulation.phase() != Phase::draping) run(simulation, 1);
    QVERIFY(simulation.restingTime() < 0.02); // it is damped as what settles still
    const auto* contact = simulation.plan().find("self-contact");
    QVERIFY(contact);
    while (simulation.restingTime() < 0.1) run(simulation, 1);
    QCOMPARE(simulation.plan().find("self-contact"), contact);
}

/// Weight acts from the first frame step after the last seam on, as long as which nothing gathers speed where coarse
/// levels draw cloth together that yielded.
void tst_Settling::whatIsLetGoDoesNotLeap() {
    const auto speedAfter = [](double spacing, int frames) {
        auto simulation = Simulation::create(fallingSquares(), {.spacing = spacing});
        while (simulation->phase() == Phase::sewing) run(*simulation, 1);
        run(*simulation, frames);
        return speedOf(*simulation);
    };
    const double fine = speedAfter(fineSpacing, 1), later = speedAfter(fineSpacing, 6), coarse = speedAfter(0.02, 1);
    QVERIFY2(fine < 2 * releaseSpeed && later > 20 * releaseSpeed && coarse > 20 * releaseSpeed,
             qPrintable(QString("%1, later %2, coarse %3 m/s").arg(fine).arg(later).arg(coarse)));
}

/// Cloth on a finer mesh folds as the coarser one did. After an edit it goes on.
void tst_Settling::whatIsRefinedDoesNotLeap() {
    const Scene scene = fallingSquares();
    const auto speedFrom = [&](double spacing) {
        auto lying = Simulation::create(scene, {.spacing = spacing});
        while (lying->phase() != Phase::draping) run(*lying, 1);
        auto goesOn = Simulation::continued(scene, *lying, {.spacing = fineSpacing});
        while (goesOn->phase() == Phase::sewing) run(*goesOn, 1);
        run(*goesOn, 1);
        return speedOf(*goesOn);
    };
    const double edited = speedFrom(fineSpacing), refined = speedFrom(0.02);
    QVERIFY2(refined < 2 * releaseSpeed && edited > 10 * refined,
             qPrintable(QString("%1 and %2 m/s").arg(edited).arg(refined)));
}

void tst_Settling::inWindItIsNotForEver() {
    Scene scene = fallingSquares();
    scene.settings.air = Air{.wind = {0, -10, 0}};
    Simulation simulation = simulationOf(scene);
    while (simulation.phase() != Phase::draping) run(simulation, 1);
    run(simulation, 60);
    const double damped = speedOf(simulation);
    run(simulation, 60 * static_cast<int>(dressing.settlingTime));
    QVERIFY2(speedOf(simulation) > 2 * damped,
             qPrintable(QString("%1, then %2 m/s").arg(damped).arg(speedOf(simulation))));
}

void tst_Settling::onceItHasLainItIsNot() {
    const Scene scene = twoSquares(0.05);
    Simulation simulation = simulationOf(scene);
    while (!simulation.frame().atRest) run(simulation, 1);
    simulation.hold({{.piece = "left", .material = {0.1, 0.1}, .target = {-0.1, 2, 0}}});
    run(simulation, 10);
    simulation.hold({});
    const double before = speedOf(simulation);
    run(simulation, 60);
    const double expected = before * std::exp(-scene.settings.damping);
    QVERIFY2(before > 0.1 && std::abs(speedOf(simulation) - expected) < 0.02 * expected,
             qPrintable(QString("%1, then %2 m/s").arg(before).arg(speedOf(simulation))));
}

void tst_Settling::whatRestsIsDampedUntilItSleeps() {
    const Scene scene = twoSquares(0.05);
    Simulation simulation = driftingAtRest(scene, driftSpeed);
    run(simulation, 15);
    const double substep = scene.settings.frameStep / simulation.substeps(); // damped implicitly in each
    const double expected = driftSpeed * std::pow(1 + substep * dressing.settlingDamping, -0.25 / substep);
    QVERIFY2(std::abs(speedOf(simulation) - expected) < 0.01 * expected,
             qPrintable(QString::number(speedOf(simulation))));
    run(simulation, 120);
    QVERIFY(simulation.sleptTime() > 0);
}

/// By a thousandth of its weight, as through friction that almost holds it.
void tst_Settling::whatSlidesDoesNotSleep() {
    const double pull = 0.001 * 9.81, expected = pull / dressing.settlingDamping;
    Simulation simulation = slidingFor(10, pull);
    QVERIFY(simulation.frame().atRest);
    QCOMPARE(simulation.sleptTime(), 0.0);
    QVERIFY2(std::abs(speedOf(simulation) - expected) < 0.01 * expected,
             qPrintable(QString::number(speedOf(simulation))));
}

void tst_Settling::whatSlidesFasterThanRestIsNotDamped() {
    const double pull = 0.005 * 9.81;
    Simulation simulation = slidingFor(10, pull);
    QVERIFY(!simulation.frame().atRest);
    QVERIFY2(speedOf(simulation) > 5 * pull / dressing.settlingDamping,
             qPrintable(QString::number(speedOf(simulation))));
}

void tst_Settling::atRestByAnAccurateMethodItIsNot() {
    const Scene scene = twoSquares(0.05);
    Simulation simulation = driftingAtRest(scene, driftSpeed, dynamics::Method::trBdf2);
    run(simulation, 15);
    const double expected = driftSpeed * std::exp(-0.25 * scene.settings.damping);
    QVERIFY2(std::abs(speedOf(simulation) - expected) < 0.02 * expected,
             qPrintable(QString::number(speedOf(simulation))));
}

void tst_Settling::whatWasNotSewnIsNot() {
    Scene scene = fallingSquares();
    scene.pattern.seams.clear();
    Simulation simulation = simulationOf(scene);
    run(simulation, 30);
    QVERIFY(speedOf(simulation) > 3 * settlingSpeed);
}

TOILE_TEST(tst_Settling)
#include "tst_Settling.moc"
