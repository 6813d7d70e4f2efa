// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/simulation/Refine.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

constexpr double coarseSpacing = 0.05, fineSpacing = 0.025;

/// Two squares that hang by the upper edge of one.
Scene hanging() {
    Scene scene = twoSquares(coarseSpacing);
    scene.settings.gravity = {0, -9.81, 0};
    scene.settings.damping = 5;
    for (const char* corner : {"v2", "v3"})
        scene.pattern.pins.push_back({pattern::PinId(corner), pattern::PieceId("left"), pattern::VertexId(corner)});
    return scene;
}

Refined refinedOf(const Scene& scene, const SewSettings& settings = {}) {
    auto found = refined(simulationOf(scene), scene, {.spacing = fineSpacing}, settings);
    if (!found) qFatal("%s", toString(found.error()).c_str());
    return std::move(*found);
}

/// Of a mesh node of a piece.
Vec3 placeOf(const Simulation& simulation, int piece, int node) {
    return simulation.state().positions[simulation.garment().particles.particle({piece, node})];
}

/// Largest distance of the nodes that two meshes of the same pieces have in common [m].
double largestDifference(const Simulation& a, const Simulation& b) {
    double largest = -1;
    for (int piece = 0; piece < std::ssize(a.garment().mesh->pieces); ++piece) {
        const auto &nodesA = a.garment().mesh->pieces[piece].nodes, &nodesB = b.garment().mesh->pieces[piece].nodes;
        for (int i = 0; i < std::ssize(nodesA); ++i)
            for (int k = 0; k < std::ssize(nodesB); ++k)
                if (distance(nodesA[i], nodesB[k]) < 1e-9)
                    largest = std::max(largest, distance(placeOf(a, piece, i), placeOf(b, piece, k)));
    }
    return largest;
}

} // namespace

class tst_Refine : public QObject {
    Q_OBJECT
private slots:
    void theDrapeIsCarriedOver();
    void theCoarseGarmentIsNotFinished();
    void itEndsWhereTheFineGarmentDoes();
    void whatWasHeldIsNotHeldAgain();
    void whatTheCoarseRunTookIsCounted();
    void aStopEndsIt();
};

/// Every coarse node is a fine one here, and lies where it lay.
void tst_Refine::theDrapeIsCarriedOver() {
    Simulation coarse = simulationOf(hanging());
    static_cast<void>(sewn(coarse, {.finish = false}));
    const Refined found = refinedOf(hanging());
    QVERIFY(found.fine.garment().mesh->pieces[0].nodes.size() > coarse.garment().mesh->pieces[0].nodes.size());
    const double difference = largestDifference(coarse, found.fine);
    QVERIFY2(difference >= 0 && difference < 1e-9, qPrintable(QString::number(difference)));
    QCOMPARE(found.coarse.particles, coarse.garment().model.particleCount());
    QCOMPARE(found.fine.state().time, coarse.state().time);
}

void tst_Refine::theCoarseGarmentIsNotFinished() {
    const Refined found = refinedOf(hanging());
    QCOMPARE(found.coarse.ending, std::string("at rest"));
    Simulation finished = simulationOf(hanging());
    static_cast<void>(sewn(finished));
    QVERIFY(largestDifference(finished, found.fine) > 1e-6);
}

/// What hangs by its pins has one equilibrium.
void tst_Refine::itEndsWhereTheFineGarmentDoes() {
    Refined found = refinedOf(hanging());
    const SewReport refinedReport = sewn(found.fine);
    auto direct = Simulation::create(hanging(), {.spacing = fineSpacing});
    QVERIFY(direct.has_value());
    const SewReport directReport = sewn(*direct);
    QVERIFY(refinedReport.atRest && directReport.atRest);
    QVERIFY(refinedReport.allClosed());
    QCOMPARE(refinedReport.particles, directReport.particles);
    const double difference = largestDifference(found.fine, *direct);
    QVERIFY2(difference < 5e-4, qPrintable(QString::number(difference)));
}

void tst_Refine::whatWasHeldIsNotHeldAgain() {
    QCOMPARE(settingsAfter({.heldSeconds = 10}, {.hold = 10}).hold, 0.0);
    QCOMPARE(settingsAfter({.heldSeconds = 0}, {.hold = 10}).hold, 10.0); // it never came to rest
}

void tst_Refine::whatTheCoarseRunTookIsCounted() {
    SewReport report;
    report.simulatedSeconds = 5; // of the state's clock, which went on
    report.cpuSeconds = 2;
    report.wallSeconds = 1;
    report.restWallSeconds = 0.5;
    const CoarseRun coarse{.particles = 7,
                           .simulatedSeconds = 3,
                           .heldSeconds = 2,
                           .sleptSeconds = 1,
                           .sleptApartSteps = 8,
                           .cpuSeconds = 4,
                           .wallSeconds = 3,
                           .ending = "at rest"};
    count(coarse, report);
    QCOMPARE(report.cpuSeconds, 6.0);
    QCOMPARE(report.wallSeconds, 4.0);
    QCOMPARE(report.restWallSeconds, 3.5);
    QCOMPARE(report.heldSeconds, 2.0);
    QCOMPARE(report.sleptSeconds, 1.0);
    QCOMPARE(report.sleptApartSteps, 8.0);
    QCOMPARE(report.simulatedSeconds, 5.0);
    QCOMPARE(report.coarse->particles, 7);
}

void tst_Refine::aStopEndsIt() {
    std::stop_source stop;
    stop.request_stop();
    const auto found = refined(simulationOf(hanging()), hanging(), {.spacing = fineSpacing}, {}, StiffBand::byInertia,
                               stop.get_token());
    QVERIFY(!found && found.error().code == ErrorCode::cancelled);
}

TOILE_TEST(tst_Refine, QCoreApplication)
#include "tst_Refine.moc"
