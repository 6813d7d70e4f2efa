// SPDX-License-Identifier: GPL-3.0-or-later
#include "SmallScenes.h"
#include "core/dynamics/Method.h"
#include "core/dynamics/Statics.h"
#include "core/simulation/Checkpoint.h"
#include "core/simulation/Topology.h"
#include "tests/Suite.h"
#include "tests/simulation/Garments.h"
#include "tests/simulation/Sewn.h"

#include <QTest>

using namespace toile;
using namespace toile::simulation;
using dynamics::Method;

namespace {

constexpr double stripLength = 0.2, stripWidth = 0.02; // along the seam, across it: one cell [m]

pattern::Pattern withElastic(pattern::Pattern pattern, pattern::Elastic elastic) {
    pattern.seams[0].elastic = elastic;
    return pattern;
}

/// Two strips of one row of cells, sewn along their warp by the ends that face each other.
pattern::Pattern strips(const material::Fabric& fabric) {
    pattern::Pattern pattern;
    pattern.fabrics.push_back(fabric);
    for (const double left : {-stripWidth, 0.0}) {
        pattern::Piece piece =
            polygonPiece(left < 0 ? "left" : "right",
                         {{0, 0}, {stripWidth, 0}, {stripWidth, stripLength}, {0, stripLength}}, stripWidth);
        piece.placement = pattern::Placement{};
        piece.placement->transform.origin = {left, 0, 0};
        pattern.pieces.push_back(std::move(piece));
    }
    pattern.seams.push_back(seamBetween("middle", "left", "e1", "right", "e3"));
    return pattern;
}

/// Threads along warp that hardly know of each other: the row of the seam is a line of its own.
material::Fabric warpAlone() {
    material::Fabric fabric = plainCloth();
    fabric.warpStiffness = 50;
    fabric.weftStiffness = 0.01;
    fabric.shearStiffness = fabric.coupling = 0;
    fabric.warpBending = fabric.weftBending = fabric.biasBending = 0;
    return fabric;
}

/// Where the nodes of the strips are placed, sewn.
dynamics::ParticleState placedState(const pattern::Pattern& pattern, const Garment& garment) {
    const std::vector<Vec3> nodes = placedNodes(pattern, *garment.mesh);
    dynamics::ParticleState state;
    state.positions.resize(garment.model.mass.size());
    state.velocities.resize(garment.model.mass.size());
    for (std::size_t node = 0; node < nodes.size(); ++node)
        state.positions[garment.particles.particleOf[node]] = nodes[node];
    return state;
}

double seamLength(const Garment& garment, std::span<const Vec3> positions) {
    double sum = 0;
    for (const cloth::Spring& s : garment.model.elastics) sum += geometry::distance(positions[s.a], positions[s.b]);
    return sum;
}

} // namespace

class tst_SeamElastics : public QObject {
    Q_OBJECT
private slots:
    void onlyAMergedSeamWithAnElasticHasOne() {
        const pattern::Pattern plain = twoSquares(0.05).pattern, drawn = withElastic(plain, {});
        QVERIFY(garmentOf(drawn, false).model.elastics.empty());
        QVERIFY(garmentOf(plain, true).model.elastics.empty());
        QCOMPARE(garmentOf(drawn, true).model.elastics.size(), std::size_t(4)); // one for each stitch
    }

    void thePaperHasNone() {
        QVERIFY(garmentOf(withElastic(twoSquares(0.05).pattern, {}), true, true).model.elastics.empty());
    }

    void togetherTheyAreAsLongAsTheBand() {
        double rest = 0;
        for (const cloth::Spring& s :
             garmentOf(withElastic(twoSquares(0.05).pattern, {.ratio = 0.6, .stiffness = 30}), true).model.elastics) {
            rest += s.restLength;
            QVERIFY(std::abs(s.stiffness * s.restLength - 30) < 1e-12); // the same tension along all of it
        }
        QVERIFY(std::abs(rest - 0.6 * 0.2) < 1e-12);
    }

    void ofAGatheredSeamTheShorterSideCounts() {
        pattern::Pattern pattern = withElastic(twoSquares(0.02).pattern, {.ratio = 0.5, .stiffness = 30});
        pattern::Piece left = *pattern.pieces[0];
        left.outline.vertices[2].position.y = left.outline.vertices[3].position.y = 0.3;
        pattern.pieces[0] = left;
        pattern.seams[0].sections = {{.ease = 0, .gatherRatio = 1.5}};
        double rest = 0;
        for (const cloth::Spring& s : garmentOf(pattern, true).model.elastics) rest += s.restLength;
        QVERIFY(std::abs(rest - 0.5 * 0.2) < 1e-9);
    }

    void aSeamRestsWhereBandAndClothBalance_data() {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("stiffness"); // [N]; the cloth's is 1 N
        for (const char* method : {"xpbd", "trbdf2", "backward-euler", "statics"})
            QTest::addRow("as stiff as the cloth, %s", method) << method << 1.0;
        for (const char* method :
             {"trbdf2", "backward-euler", "statics"}) // by positions it is no stiffer than its step
            QTest::addRow("a hundred times as stiff, %s", method) << method << 100.0;
    }

    /// Half a cell on either side of the seam resists with E·a: S·(λ/r − 1) + E·a·(λ − 1) = 0.
    void aSeamRestsWhereBandAndClothBalance() {
        QFETCH(QString, method);
        QFETCH(double, stiffness);
        constexpr double ratio = 0.7;
        const material::Fabric fabric = warpAlone();
        const pattern::Pattern pattern = withElastic(strips(fabric), {ratio, stiffness});
        const Garment garment = garmentOf(pattern, true);
        dynamics::ParticleState state = placedState(pattern, garment);
        QVERIFY(std::abs(seamLength(garment, state.positions) - stripLength) < 1e-12);
        if (method == "statics") {
            const auto report = dynamics::solveStatic(garment.model, state, {}, {}, {.tolerance = 1e-6});
            QVERIFY(report && report->newton.converged);
        } else {
            constexpr int finest = 400; // of XPBD, whose sweep leaves 0.5 mm at 100
            const auto integrator = dynamics::makeIntegrator(*dynamics::methodNamed(method.toStdString()),
                                                             garment.model, {.damping = 5, .substeps = finest});
            for (int step = 0; step < 240; ++step) QVERIFY(integrator->step(state, 1.0 / 60, {}));
        }
        const double cloth = fabric.warpStiffness * stripWidth;
        const double expected = stripLength * (stiffness + cloth) / (stiffness / ratio + cloth);
        // The weft draws at the seam with 1/5000 of the warp's stiffness.
        QVERIFY2(std::abs(seamLength(garment, state.positions) - expected) < 3e-4 * stripLength,
                 qPrintable(QStringLiteral("%1 m, not %2 m")
                                .arg(seamLength(garment, state.positions), 0, 'g', 8)
                                .arg(expected, 0, 'g', 8)));
    }

    void aSewnGarmentIsDrawnUp() {
        Scene scene = twoSquares(0.05);
        const auto lengthSewn = [](const Scene& s) {
            Simulation simulation = simulationOf(s);
            const SewReport report = sewn(simulation, {});
            if (!report.allClosed()) qFatal("a seam is open");
            const Garment& garment = simulation.garment();
            const auto& pairs = garment.mesh->seams[0].pairs;
            double sum = 0;
            for (std::size_t i = 1; i < pairs.size(); ++i)
                sum += geometry::distance(simulation.state().positions[garment.particles.particle(pairs[i - 1][0])],
                                          simulation.state().positions[garment.particles.particle(pairs[i][0])]);
            return sum;
        };
        const double plain = lengthSewn(scene);
        scene.pattern = withElastic(scene.pattern, {.ratio = 0.7, .stiffness = 500});
        QVERIFY(lengthSewn(scene) < 0.85 * plain);
    }

    void aCheckpointKnowsThem_data() {
        QTest::addColumn<bool>("merged");
        QTest::newRow("open") << false;
        QTest::newRow("merged") << true;
    }
    void aCheckpointKnowsThem() {
        QFETCH(bool, merged);
        Scene scene = twoSquares(0.05);
        const auto fingerprint = [&](pattern::Elastic elastic) {
            scene.pattern = withElastic(scene.pattern, elastic);
            return fingerprintOf(scene, garmentOf(scene.pattern, merged));
        };
        const std::string usual = fingerprint({});
        QVERIFY(usual == fingerprint({}));
        QVERIFY(usual != fingerprint({.ratio = 0.71}) && usual != fingerprint({.stiffness = 41}));
    }
};

TOILE_TEST(tst_SeamElastics, QCoreApplication)
#include "tst_SeamElastics.moc"
