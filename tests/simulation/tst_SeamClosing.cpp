// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sewn.h"
#include "SmallScenes.h"
#include "core/simulation/SeamClosing.h"
#include "core/simulation/Sew.h"
#include "tests/Suite.h"

#include <QTest>
#include <array>
#include <cmath>
#include <limits>

using namespace toile;
using namespace toile::simulation;

namespace {

/// A square that climbs from its outer edge, which is pinned at both corners, towards the peg.
void climb(pattern::Pattern& pattern, int square, const Vec3& outer, const Vec3& inward,
           const std::array<const char*, 2>& pinned) {
    pattern::Piece piece = *pattern.pieces[square];
    const Vec3 x = square == 0 ? inward : -inward, along{0, 0, -1};
    piece.placement->transform = {x, along, cross(x, along), square == 0 ? outer : outer + inward * 0.2};
    pattern.pieces[square] = piece;
    for (const char* vertex : pinned)
        pattern.pins.push_back({pattern::PinId(piece.id.value + vertex), piece.id, pattern::VertexId(vertex)});
}

/// The squares together are a fiftieth too short for their way over a peg that stands 10 mm to the left of the seam.
Scene squaresOverAPeg() {
    Scene scene = twoSquares();
    scene.body = Shared<body::Body>({"peg", shapes::box({-0.014, 0.992, -0.104}, {-0.006, 1, -0.096}), {}, {}});
    const double slope = 0.8, left = 0.19, right = 0.4 * 1.02 - left;
    const Vec3 top{-0.01, 1.003, 0}, up{std::cos(slope), std::sin(slope), 0}, down{up.x, -up.y, 0};
    climb(scene.pattern, 0, top - up * left, up, {"v0", "v3"});
    climb(scene.pattern, 1, top + down * right, -down, {"v1", "v2"});
    return scene;
}

} // namespace

class tst_SeamClosing : public QObject {
    Q_OBJECT
private slots:
    void theAllowedGapGoesToZeroInItsTime();
    void aLongGapTakesLonger();
    void theForceIsMinusTheGradientOfTheEnergyAndStaysBounded();
    void aForceGrowsInItsTime();
    void seamsOfAHigherOrderWait();
    void aSeamIsNotGivenUpWhileItHasALongWayToGo();
    void aSeamMergesThoughOneSideAloneRestsOnTheBody();
    void whatIsHeldALittleOpenMergesLate_data();
    void whatIsHeldALittleOpenMergesLate();
    void sewingIsBitwiseRepeatable();
};

void tst_SeamClosing::theAllowedGapGoesToZeroInItsTime() {
    const SeamPair pair{0, 1, 0.2, 1.0};
    QCOMPARE(SeamClosing::allowedGap(pair, 0.5, {}), 0.2);
    QCOMPARE(SeamClosing::allowedGap(pair, 1.3, {}), 0.1); // half-way of a ramp that is symmetric
    QCOMPARE(SeamClosing::allowedGap(pair, 1.6, {}), 0.0);
}

void tst_SeamClosing::aLongGapTakesLonger() {
    const SeamPair pair{0, 1, 10, 0}; // at 5 m/s and 1.5 times the mean speed: 3 s
    QVERIFY(SeamClosing::allowedGap(pair, 2.9, {}) > 0);
    QCOMPARE(SeamClosing::allowedGap(pair, 3.0, {}), 0.0);
}

void tst_SeamClosing::theForceIsMinusTheGradientOfTheEnergyAndStaysBounded() {
    const std::vector<double> mass{2e-5, 1e-5};
    SeamClosing seam({{0, 1, 1, 0}}, {.maximumForce = 0.5, .stiffness = 500}, mass); // constant from a gap of 1 mm on
    QCOMPARE(seam.largestFrequencySquared(), 2 * 500 / 1e-5);
    constexpr double step = 1e-7;
    for (const double gap : {0.0002, 0.00099, 0.00101, 0.3}) {
        std::vector<Vec3> x{{0, 0, 0}, {gap * 0.6, 0, gap * 0.8}};
        std::vector<Vec3> forces(2);
        seam.addForces(x, forces);
        QVERIFY(length(forces[0] + forces[1]) < 1e-15);
        QVERIFY(std::abs(length(forces[0]) - std::min(0.5, 500 * gap)) < 1e-12);
        for (int axis = 0; axis < 3; ++axis) {
            auto more = x, less = x;
            more[1][axis] += step;
            less[1][axis] -= step;
            QVERIFY(std::abs((seam.energy(more) - seam.energy(less)) / (2 * step) + forces[1][axis]) < 1e-4);
        }
    }
}

void tst_SeamClosing::aForceGrowsInItsTime() {
    SeamClosing seam({{0, 1, 1, 2.0}}, {.maximumForce = 4, .stiffness = 500, .forceRamp = 1},
                     std::vector<double>{1, 1});
    const std::vector<Vec3> x{{}, {1, 0, 0}};
    for (const auto& [time, expected] : {std::pair{1.0, 0.0}, {2.25, 1.0}, {3.0, 4.0}, {9.0, 4.0}}) {
        dynamics::ParticleState state;
        state.time = time;
        seam.beginStep(state, 0);
        std::vector<Vec3> forces(2);
        seam.addForces(x, forces);
        QCOMPARE(length(forces[0]), expected);
    }
}

void tst_SeamClosing::seamsOfAHigherOrderWait() {
    Scene scene = twoSquares();
    pattern::Seam second = seamBetween("outer", "left", "e3", "right", "e1");
    second.order = 1;
    scene.pattern.seams.push_back(second);
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    QVERIFY(simulation->advance());
    const double start = simulation->gapOf(1).maximum;
    while (!simulation->seams()[0].merged && simulation->state().time < 3) QVERIFY(simulation->advance());
    QVERIFY(simulation->seams()[0].merged);
    QVERIFY(!simulation->seams()[1].merged);
    QVERIFY(simulation->gapOf(1).maximum < start); // the outer edges came along, no more
    while (!simulation->seams()[1].merged && simulation->state().time < 6) QVERIFY(simulation->advance());
    QVERIFY(simulation->seams()[1].merged);
}

/// 10 m at 5 m/s are 3 s, longer than a seam of a short way is waited for.
void tst_SeamClosing::aSeamIsNotGivenUpWhileItHasALongWayToGo() {
    Scene scene = twoSquares();
    pattern::Piece far = *scene.pattern.pieces[1];
    far.placement->transform.origin.x = 10;
    scene.pattern.pieces[1] = far;
    auto simulation = Simulation::create(scene);
    QVERIFY(simulation);
    while (!simulation->allSeamsMerged() && simulation->state().time < 4) {
        QCOMPARE(simulation->phase(), Phase::sewing);
        QVERIFY(simulation->advance());
    }
    QVERIFY(simulation->allSeamsMerged());
    QVERIFY(simulation->state().time > 2.7);
}

/// The peg lifts the cell on one side of one pair, the other side hangs on it by the seam alone. What the push of a
/// single substep parts must not keep the seam from merging.
void tst_SeamClosing::aSeamMergesThoughOneSideAloneRestsOnTheBody() {
    auto simulation = Simulation::create(squaresOverAPeg());
    QVERIFY2(simulation, simulation ? "" : toString(simulation.error()).c_str());
    while (!simulation->allSeamsMerged() && simulation->state().time < 2) QVERIFY(simulation->advance());
    QVERIFY2(simulation->allSeamsMerged(), qPrintable(QString("%1 mm").arg(1000 * simulation->gapOf(0).maximum)));
    QVERIFY(simulation->seams()[0].gapAtMerge <= 0.5e-3);
}

void tst_SeamClosing::whatIsHeldALittleOpenMergesLate_data() {
    QTest::addColumn<double>("gap");
    QTest::addColumn<double>("mergesAfter"); // its ramp [s]
    QTest::newRow("0.4 mm") << 0.4e-3 << 0.0;
    QTest::newRow("1.5 mm") << 1.5e-3 << 1.0;
    QTest::newRow("2.5 mm") << 2.5e-3 << std::numeric_limits<double>::infinity();
}

/// Pins hold the ends of the seam apart.
void tst_SeamClosing::whatIsHeldALittleOpenMergesLate() {
    QFETCH(double, gap);
    QFETCH(double, mergesAfter);
    Scene scene = twoSquares();
    scene.settings.gravity = {};
    const double apart = simulationOf(scene).gapOf(0).maximum;
    pattern::Piece right = *scene.pattern.pieces[1];
    right.placement->transform.origin.x -= apart - gap;
    scene.pattern.pieces[1] = right;
    for (const auto& [piece, vertex] : {std::pair{"left", "v1"}, {"left", "v2"}, {"right", "v0"}, {"right", "v3"}})
        scene.pattern.pins.push_back(
            {pattern::PinId(std::string(piece) + vertex), pattern::PieceId(piece), pattern::VertexId(vertex)});
    Simulation simulation = simulationOf(scene);
    const double ramp = SeamClosing::durationOf(gap, {.duration = scene.settings.seamTime}), frame = 1.0 / 60;
    const auto go = [&](double until) {
        while (simulation.state().time < until - frame / 2)
            if (!simulation.advance()) qFatal("a step failed");
    };
    if (mergesAfter > 0) go(ramp + std::min(mergesAfter, 4.0) - frame);
    QVERIFY(!simulation.allSeamsMerged());
    go(ramp + std::min(mergesAfter, 4.0) + 3 * frame);
    QCOMPARE(simulation.allSeamsMerged(), std::isfinite(mergesAfter));
    if (simulation.allSeamsMerged()) QVERIFY(std::abs(simulation.seams()[0].gapAtMerge - gap) < 1e-6);
    else QVERIFY(simulation.phase() != Phase::sewing); // it was given up
}

void tst_SeamClosing::sewingIsBitwiseRepeatable() {
    std::vector<std::string> hashes;
    for (int run = 0; run < 2; ++run) {
        auto simulation = Simulation::create(twoSquares());
        const auto report = sew(*simulation, {.seconds = 1.0});
        QVERIFY(report);
        hashes.push_back(report->resultHash);
    }
    QCOMPARE(hashes[0], hashes[1]);
}

TOILE_TEST(tst_SeamClosing)
#include "tst_SeamClosing.moc"
