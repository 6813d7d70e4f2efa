// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/dynamics/Energy.h"
#include "core/material/FabricPresets.h"
#include "tests/Suite.h"
#include "tests/simulation/Sewn.h"

#include <QTest>
#include <algorithm>

using namespace toile;
using namespace toile::simulation;
using dynamics::Method;

namespace {

/// A metre of poplin that is let go level, held by two corners: woven cloth is stiff for frame steps.
Scene heldPoplin() {
    Scene scene;
    scene.pattern.fabrics.push_back(material::poplin());
    pattern::Piece piece = polygonPiece("sheet", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 0.0625);
    piece.fabric = scene.pattern.fabrics.front()->id;
    piece.placement = pattern::Placement{};
    piece.placement->transform.axisY = {0, 0, -1};
    piece.placement->transform.axisZ = {0, 1, 0};
    scene.pattern.pieces.push_back(Shared<pattern::Piece>(std::move(piece)));
    for (const char* vertex : {"v2", "v3"})
        scene.pattern.pins.push_back({pattern::PinId(vertex), pattern::PieceId("sheet"), pattern::VertexId(vertex)});
    return scene;
}

double energyOf(const Simulation& simulation) {
    return dynamics::energies(simulation.garment().model, simulation.state(), simulation.scene().settings.gravity)
        .total();
}

void everyMethod() {
    QTest::addColumn<Method>("method");
    for (const Method method : dynamics::allMethods()) // of XPBD's softened cloth what it stores is not known
        if (method != Method::xpbd) QTest::newRow(std::string(nameOf(method)).c_str()) << method;
}

bool warnsOf(const SewReport& report, std::string_view method) {
    return std::ranges::any_of(report.warnings, [&](const Warning& warning) {
        return warning.text.find(method) != std::string::npos && warning.text.find("instead") != std::string::npos;
    });
}

int redoneSteps(const SewReport& report) {
    int sum = 0;
    for (const PhaseRun& phase : report.phases) sum += phase.redoneSteps;
    return sum;
}

} // namespace

/// No method that drapes a garment gains energy unseen.
class tst_EnergyByMethods : public QObject {
    Q_OBJECT

private slots:
    void aFallingSheetGainsNone_data() { everyMethod(); }
    void aFallingSheetGainsNone() {
        QFETCH(Method, method);
        Simulation simulation = simulationOf(heldPoplin());
        simulation.drapeWith(method);
        const double start = energyOf(simulation);
        double most = start, lowest = start;
        const auto report = sew(simulation, {.seconds = 1.5}, {}, {}, [&](const Simulation& now) {
            most = std::max(most, energyOf(now));
            lowest = std::min(lowest, energyOf(now));
        });
        QVERIFY2(report, report ? "" : report.error().text.c_str());
        QVERIFY2(most - start <= 0.01 * (start - lowest), qPrintable(QString::number(most - start)));
        QVERIFY2(report->strain.warpMaximum < 0.02, qPrintable(QString::number(report->strain.warpMaximum)));
        QCOMPARE(warnsOf(*report, nameOf(method)), redoneSteps(*report) > 0);
    }

    void whatCannotDampStiffClothIsHelped() {
        for (const Method method : {Method::midpoint, Method::sdirk4}) {
            Simulation simulation = simulationOf(heldPoplin());
            simulation.drapeWith(method);
            const SewReport report = sewn(simulation, {.seconds = 1});
            QVERIFY(redoneSteps(report) > 0);
            QVERIFY(report.phases.back().steps.repeated >= redoneSteps(report));
            QCOMPARE(report.phases.back().unsolvedSteps, 0);
        }
    }

    void whatDampsItIsLeftAlone_data() {
        QTest::addColumn<Method>("method");
        for (const Method method : {Method::trBdf2, Method::backwardEuler, Method::bdf2, Method::rk4,
                                    Method::symplecticEuler, Method::baraffWitkin})
            QTest::newRow(std::string(nameOf(method)).c_str()) << method;
    }
    void whatDampsItIsLeftAlone() {
        QFETCH(Method, method);
        Simulation simulation = simulationOf(heldPoplin());
        simulation.drapeWith(method);
        QCOMPARE(redoneSteps(sewn(simulation, {.seconds = 1})), 0);
    }

    void clothThatLandsIsNotAccusedOfWhatContactStored() {
        for (const Method method : {Method::backwardEuler, Method::bdf2}) {
            Simulation simulation = simulationOf(sheetOnTable());
            simulation.drapeWith(method);
            QCOMPARE(redoneSteps(sewn(simulation, {.seconds = 1})), 0);
        }
    }
};

TOILE_TEST(tst_EnergyByMethods)
#include "tst_EnergyByMethods.moc"
