// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/cloth/Patch.h"
#include "core/dynamics/Statics.h"
#include "core/pattern/PatternFabrics.h"
#include "core/pattern/PatternPieces.h"
#include "core/simulation/Topology.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"
#include "tests/simulation/Sewn.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;

namespace {

const pattern::PieceId right("right"), sheet("sheet");

Scene frozen(Scene scene, const pattern::PieceId& piece, bool on = true) {
    scene.pattern = *pattern::setFrozen(scene.pattern, piece, on);
    return scene;
}

double largestDistance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, geometry::distance(a[i], b[i]));
    return largest;
}

/// A small sheet that falls on a frozen one, 20 mm below it.
Scene sheetOnFrozenSheet() {
    Scene scene = sheetOnTable();
    scene.body.reset();
    scene.settings.selfContact = true;
    pattern::Piece small = polygonPiece("small", {{0.05, 0.05}, {0.25, 0.05}, {0.25, 0.25}, {0.05, 0.25}}, 0.03);
    small.placement = scene.pattern.pieces[0]->placement;
    small.placement->transform.origin.y += 0.02;
    scene.pattern.pieces.push_back(std::move(small));
    return frozen(scene, sheet);
}

} // namespace

class tst_FrozenPieces : public QObject {
    Q_OBJECT
private slots:
    void whatIsSewnToItDoesNotMoveIt_data() {
        QTest::addColumn<QString>("method");
        for (const char* method : {"xpbd", "trbdf2", "statics"}) QTest::newRow(method) << method;
    }
    void whatIsSewnToItDoesNotMoveIt() {
        QFETCH(QString, method);
        Scene scene = twoSquares(0.05);
        scene.settings.gravity = {0, -9.81, 0};
        Simulation simulation = simulationOf(frozen(scene, right));
        simulation.drapeWith(dynamics::methodNamed(method.toStdString())); // statics: none
        const auto there = nodesOf(simulation, 1), other = nodesOf(simulation, 0);
        const SewReport report = sewn(simulation, method == "statics" ? SewSettings{} : SewSettings{.seconds = 4});
        QVERIFY(report.allClosed());
        QVERIFY(method != "statics" || report.atRest);
        QVERIFY(nodesOf(simulation, 1) == there);
        QVERIFY(largestDistance(nodesOf(simulation, 0), other) > 0.1); // the gap was 0.2 m
    }

    void othersLieOnIt() {
        Simulation simulation = simulationOf(sheetOnFrozenSheet());
        const auto there = nodesOf(simulation, 0), other = nodesOf(simulation, 1);
        run(simulation, 60);
        QVERIFY(nodesOf(simulation, 0) == there);
        const auto now = nodesOf(simulation, 1);
        QVERIFY(largestDistance(now, other) > 0.015);
        for (const Vec3& node : now) QVERIFY(node.y > there[0].y);
    }

    void frozenWhileItRunsItStaysWhereItLies() {
        const Scene scene = sheetOnTable(0.6);
        Simulation falling = simulationOf(scene);
        run(falling, 5);
        const auto inTheAir = nodesOf(falling, 0);
        auto held = Simulation::continued(frozen(scene, sheet), falling);
        QVERIFY(held);
        const auto there = nodesOf(*held, 0);
        QVERIFY(largestDistance(there, inTheAir) < 1e-12); // rounding of the carry-over
        run(*held, 20);
        QVERIFY(nodesOf(*held, 0) == there);
        auto freed = Simulation::continued(scene, *held);
        QVERIFY(freed);
        run(*freed, 10);
        QVERIFY(largestDistance(nodesOf(*freed, 0), there) > 0.01);
    }

    void aSewnGarmentGoesOnSewn() {
        const Scene scene = twoSquares(0.05);
        Simulation simulation = simulationOf(scene);
        QVERIFY(sewn(simulation).allClosed());
        const auto there = nodesOf(simulation, 1);
        auto held = Simulation::continued(frozen(scene, right), simulation);
        QVERIFY(held);
        run(*held, 10);
        QVERIFY(held->allSeamsMerged());
        QVERIFY(largestDistance(nodesOf(*held, 1), there) < 1e-12);
    }

    void aGarmentThatIsAllFrozenStands_data() { whatIsSewnToItDoesNotMoveIt_data(); }
    void aGarmentThatIsAllFrozenStands() {
        QFETCH(QString, method);
        Simulation simulation = simulationOf(frozen(sheetOnTable(), sheet));
        simulation.drapeWith(dynamics::methodNamed(method.toStdString()));
        const auto there = nodesOf(simulation, 0);
        if (method == "statics") QVERIFY(simulation.settle({}));
        else run(simulation, 10);
        QVERIFY(nodesOf(simulation, 0) == there);
    }

    void strengthenedClothIsStifferToBendAlone() {
        const pattern::Pattern plain = twoSquares(0.05).pattern;
        pattern::Pattern stiff = plain;
        for (const auto& piece : plain.pieces) stiff = *pattern::setStrengthened(stiff, piece->id, true);
        const cloth::ClothModel a = garmentOf(plain, true).model, b = garmentOf(stiff, true).model;
        const auto isFactor = [](const auto& from, const auto& to, double factor) {
            return !from.empty() && std::ranges::equal(from, to, [&](const auto& x, const auto& y) {
                return std::abs(y.stiffness - factor * x.stiffness) <= 1e-12 * y.stiffness;
            });
        };
        QVERIFY(isFactor(a.bending, b.bending, pattern::strengthening));
        QVERIFY(isFactor(a.hinges, b.hinges, pattern::strengthening));
        QVERIFY(isFactor(a.structural, b.structural, 1) && isFactor(a.shear, b.shear, 1));
        QVERIFY(a.mass == b.mass);
    }

    /// A strip that is clamped at one end sags by q·L⁴/8B as long as it sags little.
    void strengthenedClothSagsLess() {
        constexpr double spacing = 0.01, free = 0.06, width = 0.03;
        Scene scene;
        scene.pattern.fabrics.push_back(plainCloth());
        scene.pattern.pieces.push_back(
            polygonPiece("strip", {{0, 0}, {free + spacing, 0}, {free + spacing, width}, {0, width}}, spacing));
        const auto sagOf = [&](const pattern::Pattern& pattern) {
            Garment garment = garmentOf(pattern);
            dynamics::ParticleState state;
            for (const Vec2 p : garment.mesh->pieces[0].nodes) {
                if (p.x < 1.5 * spacing) garment.model.pinned.push_back(static_cast<int>(state.positions.size()));
                state.positions.push_back({p.x, 0, -p.y});
            }
            state.velocities.resize(state.positions.size());
            cloth::doubleBendingAtClampedRows(garment.model);
            const auto rest = dynamics::solveStatic(garment.model, state, {0, -9.81, 0}, {}, {.tolerance = 1e-4});
            if (!rest || !rest->newton.converged) qFatal("it finds no rest");
            return -std::ranges::min(state.positions, {}, &Vec3::y).y;
        };
        const material::Fabric& cloth = *scene.pattern.fabrics[0];
        const double load = 9.81 * cloth.arealDensity, bending = pattern::strengthening * cloth.weftBending;
        const double expected = load * std::pow(free, 4) / (8 * bending);
        QVERIFY(sagOf(scene.pattern) > 0.3 * free);
        const double sag = sagOf(*pattern::setStrengthened(scene.pattern, pattern::PieceId("strip"), true));
        // Six cells along the strip; a free edge also bends across a little.
        QVERIFY2(std::abs(sag - expected) < 0.1 * expected,
                 qPrintable(QStringLiteral("%1 m, not %2 m").arg(sag).arg(expected)));
    }
};

TOILE_TEST(tst_FrozenPieces, QCoreApplication)
#include "tst_FrozenPieces.moc"
