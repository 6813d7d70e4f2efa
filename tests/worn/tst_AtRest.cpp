// SPDX-License-Identifier: GPL-3.0-or-later
#include "WornScenes.h"
#include "core/simulation/Checkpoint.h"
#include "core/simulation/Speeds.h"
#include "samples/Shirt.h"
#include "samples/TShirt.h"
#include "tests/Suite.h"

using namespace toile;
using namespace toile::simulation;

namespace {

double farthestMove(std::span<const Vec3> from, std::span<const Vec3> to) {
    double most = 0;
    for (std::size_t p = 0; p < from.size(); ++p) most = std::max(most, geometry::distance(from[p], to[p]));
    return most;
}

/// The same garment where it lies, without damping and in half the frame steps: nothing that is not in the balance of
/// forces holds it there.
Result<Simulation> undampedFrom(Simulation& simulation) {
    Scene scene = simulation.scene();
    scene.settings.damping = 0;
    scene.settings.frameStep /= 2;
    Checkpoint point = simulation.checkpoint();
    point.scene = fingerprintOf(scene, simulation.garment());
    auto undamped = Simulation::resumed(std::move(scene), {}, point);
    if (undamped) undamped->drapeWith(dynamics::Method::trBdf2);
    return undamped;
}

pattern::Pattern coarseTShirt() {
    return samples::tShirt(mannequin().measurements, mannequin().body, {.spacing = 0.028}).value().pattern;
}

} // namespace

/// What a run calls the equilibrium is one.
class tst_AtRest : public QObject {
    Q_OBJECT
private slots:
    void anUndampedGarmentStaysWhereItRests_data() {
        QTest::addColumn<Scene>("scene");
        const Scene blouse = onBlouseWearer(blouseAt(0.028));
        Scene layered = blouse;
        layered.settings.selfContact = true;
        QTest::newRow("blouse") << blouse;
        QTest::newRow("blouse with self-contact") << layered;
        QTest::newRow("T-shirt") << onMannequin(coarseTShirt());
    }
    void anUndampedGarmentStaysWhereItRests() {
        QFETCH(Scene, scene);
        auto simulation = Simulation::create(scene);
        QVERIFY(simulation);
        const auto report = sew(*simulation, {});
        QVERIFY(report && report->atRest);
        const std::vector<Vec3> resting = simulation->state().positions;
        auto undamped = undampedFrom(*simulation);
        QVERIFY2(undamped, undamped ? "" : toString(undamped.error()).c_str());
        const double end = undamped->state().time + 1;
        double farthest = 0;
        while (undamped->state().time < end) {
            QVERIFY(undamped->advance());
            QCOMPARE(undamped->sleptTime(), 0.0);
            farthest = std::max(farthest, farthestMove(resting, undamped->state().positions));
        }
        qInfo("farthest %.1f mm from where it rested", 1000 * farthest);
        QVERIFY2(farthest < 0.001, qPrintable(QString("%1 mm").arg(1000 * farthest)));
    }

    void strongStrainDampingBringsToRest_data() {
        QTest::addColumn<double>("time");
        for (const double time : {0.01, 0.1, 1.0}) QTest::addRow("%g s", time) << time;
    }
    void strongStrainDampingBringsToRest() {
        QFETCH(double, time);
        Scene scene = onMannequin(coarseTShirt());
        scene.settings.strainDamping = time;
        const SewReport report = sewn(scene);
        QVERIFY(report.atRest);
        QVERIFY2(report.worn->worn, reasonsOf(report).c_str());
    }

    /// The sample shirt on cells of 28 mm: where its collar is crumpled on its stand, it trembles for as long as it is
    /// simulated.
    void whatTremblesInPlaceRestsAsWell() {
        const auto shirt = samples::shirt(blouseWearer().measurements, blouseWearer().body);
        QVERIFY(shirt);
        const Scene scene{shirt->pattern, Shared<body::Body>(blouseWearer().body), shirt->scene};
        auto simulation = Simulation::create(scene, {.spacing = 0.028});
        QVERIFY(simulation);
        static_cast<void>(sewn(*simulation, {.seconds = 9}));
        int fast = 0; // frame steps in which it does not look like rest
        for (int frame = 0; frame < 30; ++frame) {
            const std::vector<Vec3> before = simulation->state().positions;
            run(*simulation, 1);
            fast += !speedsOf(simulation->garment().model.mass, before, simulation->state().positions, 1.0 / 60)
                         .areOfRest();
        }
        QVERIFY2(fast > 0, "It does not tremble.");
        const SewReport report = sewn(*simulation);
        QVERIFY(report.atRest);
        QVERIFY(simulation->state().time < 13);
        QVERIFY2(report.worn->worn, report.worn->why.empty() ? "" : report.worn->why[0].c_str());
    }
};

TOILE_TEST(tst_AtRest, QCoreApplication)
#include "tst_AtRest.moc"
