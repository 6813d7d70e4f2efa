// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/Energy.h"
#include "core/dynamics/ImplicitRungeKutta.h"
#include "core/dynamics/SymplecticEuler.h"
#include "core/dynamics/Xpbd.h"
#include "tests/validation/Case.h"

#include <fmt/format.h>
#include <functional>
#include <optional>

using namespace toile;
using namespace toile::fixtures;
using namespace toile::validation;
using dynamics::ParticleState;

namespace {

constexpr double g = 9.81, pi = std::numbers::pi;
const Vec3 gravity{0, -g, 0};

void need(const auto& done) {
    if (!done) qFatal("%s", toString(done.error()).c_str());
}

/// Mean time between rising zero crossings of a signal sampled every h, over `count` periods.
double periodOf(const std::function<double()>& nextSample, double h, int count) {
    double last = nextSample(), first = 0;
    int crossings = 0;
    for (long sample = 1; sample < 50'000'000; ++sample) {
        const double now = nextSample();
        if (last < 0 && now >= 0) {
            const double at = (static_cast<double>(sample) - now / (now - last)) * h;
            if (crossings == 0) first = at;
            if (crossings == count) return (at - first) / count;
            ++crossings;
        }
        last = now;
    }
    qFatal("the signal does not oscillate");
    return 0;
}

/// One mass on one spring along x; V1.
struct Oscillator {
    ClothModel model;
    ParticleState state;
};
Oscillator oscillator(double amplitude) {
    Oscillator o;
    o.model.mass = {0.01, 0.01};
    o.model.structural = {{0, 1, 1, 100}};
    o.model.pinned = {0};
    o.state.positions = {{0, 0, 0}, {1 + amplitude, 0, 0}};
    o.state.velocities.resize(2);
    return o;
}

using Step = std::function<void(ParticleState&, double)>;

/// Error of the oscillator's position after a quarter second, relative to its amplitude.
double oscillatorError(const std::function<Step(const ClothModel&)>& makeStep, double h) {
    Oscillator o = oscillator(1e-3);
    const Step step = makeStep(o.model);
    const int steps = static_cast<int>(std::lround(0.25 / h));
    for (int i = 0; i < steps; ++i) step(o.state, h);
    return std::abs(o.state.positions[1].x - 1 - 1e-3 * std::cos(100 * 0.25)) / 1e-3;
}

Step symplectic(const ClothModel& model) {
    auto euler = std::make_shared<dynamics::SymplecticEuler>(model);
    return [euler](ParticleState& s, double h) { need(euler->step(s, h, {})); };
}

Step implicit(const ClothModel& model) {
    auto euler = std::make_shared<dynamics::ImplicitRungeKutta>(model, dynamics::backwardEuler(),
                                                                dynamics::ImplicitSettings{.tolerance = 1e-12});
    return [euler](ParticleState& s, double h) { need(euler->step(s, h, {})); };
}

/// V8: a mass on a stiff spring of length 1, let go at an angle. Period over that of small swings.
double pendulumRatio(double degrees, const std::function<Step(const ClothModel&)>& makeStep, double h) {
    ClothModel model;
    model.mass = {1, 1};
    model.structural = {{0, 1, 1, 1e6}};
    model.pinned = {0};
    const double angle = degrees * pi / 180;
    ParticleState state{.positions = {{0, 0, 0}, {std::sin(angle), -std::cos(angle), 0}}, .velocities = {{}, {}}};
    const Step step = makeStep(model);
    const double period = periodOf(
        [&] {
            step(state, h);
            return state.positions[1].x;
        },
        h, 1);
    return period / (2 * pi / std::sqrt(g));
}

ClothModel sheetModel(Patch& patch, int cells, const Fabric& fabric) {
    patch = gridPatch(evenLines(0.2, cells), evenLines(0.2, cells));
    return modelOf(patch, fabric);
}

/// V15: lowest frequency of a square membrane of side 1 under tension 10 N/m, N × N cells.
double membraneFrequency(int n) {
    constexpr double tension = 10, stiffness = 1000, density = 0.2;
    const double strain =
        tension / (stiffness - tension); // E·e/(1 + e) = T: stiffness per rest width, load per real one
    const double side = 1 / (1 + strain);
    Fabric fabric = wovenFabric();
    fabric.arealDensity = density / (side * side);
    fabric.warpStiffness = fabric.weftStiffness = stiffness;
    fabric.shearStiffness = 0;
    fabric.warpBending = fabric.weftBending = fabric.biasBending = 0;
    const Patch patch = gridPatch(evenLines(side, n), evenLines(side, n));
    ClothModel model = modelOf(patch, fabric);
    ParticleState state;
    for (int p = 0; p < model.particleCount(); ++p) {
        const int i = p % (n + 1), j = p / (n + 1);
        if (i == 0 || j == 0 || i == n || j == n) model.pinned.push_back(p);
        state.positions.push_back({double(i) / n, double(j) / n, -1e-5 * std::sin(pi * i / n) * std::sin(pi * j / n)});
    }
    state.velocities.resize(state.positions.size());
    dynamics::SymplecticEuler euler(model);
    const double h = std::min(1e-4, 0.5 * euler.stepLimit());
    const int middle = (n / 2) * (n + 1) + n / 2;
    return 1 / periodOf(
                   [&] {
                       need(euler.step(state, h, {}));
                       return state.positions[middle].z;
                   },
                   h, 2);
}

} // namespace

class tst_DynamicCases : public QObject {
    Q_OBJECT

private slots:
    void v1OscillatorFrequency() {
        Oscillator o = oscillator(1e-3);
        dynamics::SymplecticEuler euler(o.model);
        const double period = periodOf(
            [&] {
                need(euler.step(o.state, 1e-4, {}));
                return o.state.positions[1].x - 1;
            },
            1e-4, 10);
        QVERIFY(caseWithin("V1", "oscillator, symplectic Euler at 1e-4 s, frequency", 15.9155, 1 / period, 1e-4));

        Oscillator x = oscillator(1e-3);
        dynamics::Xpbd xpbd(x.model, {.damping = 0, .stiffnessCap = 1e9});
        const double xpbdPeriod = periodOf(
            [&] {
                need(xpbd.step(x.state, 1e-5, 1, {}, {}));
                return x.state.positions[1].x - 1;
            },
            1e-5, 3);
        QVERIFY(caseWithin("V1", "oscillator, XPBD at 1e-5 s, frequency", 15.9155, 1 / xpbdPeriod, 1e-4));
    }

    void v1ImplicitEulerDampsByItsFormula() {
        constexpr double h = 1e-3, ratio = 100 * h; // ωh = 0.1
        Oscillator o = oscillator(1e-3);
        const Step step = implicit(o.model);
        const auto energy = [&] {
            const double x = o.state.positions[1].x - 1, v = o.state.velocities[1].x;
            return 0.5 * 100 * x * x + 0.5 * 0.01 * v * v;
        };
        const double before = energy();
        for (int i = 0; i < 10; ++i) step(o.state, h);
        const double measured = std::pow(energy() / before, 0.5 / 10); // amplitude per step
        QVERIFY(caseWithin("V1", "oscillator, backward Euler at ωh=0.1, damping a step",
                           1 / std::sqrt(1 + ratio * ratio), measured, 1e-6));
    }

    void v2OrdersOfTheIntegrators() {
        const auto order = [](const auto& makeStep) {
            const double coarse = oscillatorError(makeStep, 0.25 / 2000),
                         fine = oscillatorError(makeStep, 0.25 / 16000);
            return std::log2(coarse / fine) / 3; // halved three times
        };
        QVERIFY(caseWithin("V2", "order of symplectic Euler", 1, order(symplectic), 0.15));
        QVERIFY(caseWithin("V2", "order of backward Euler", 1, order(implicit), 0.15));
    }

    void v8PendulumPeriods() {
        struct Row {
            double degrees, ratio;
        };
        for (const Row& row : {Row{10, 1.0019072}, {45, 1.0399733}, {90, 1.1803406}, {150, 1.7622037}}) {
            const auto euler = [](const ClothModel& model) -> Step {
                auto e = std::make_shared<dynamics::SymplecticEuler>(model);
                return [e](ParticleState& s, double h) { need(e->step(s, h, gravity)); };
            };
            QVERIFY(caseWithin("V8", fmt::format("pendulum from {}°, symplectic Euler", row.degrees), row.ratio,
                               pendulumRatio(row.degrees, euler, 2e-4), 1e-3));
            if (row.degrees > 90) continue; // XPBD loses energy by O(h), and there the period depends most on it
            const auto xpbd = [](const ClothModel& model) -> Step {
                auto x = std::make_shared<dynamics::Xpbd>(model, dynamics::XpbdSettings{.damping = 0});
                return [x](ParticleState& s, double h) { need(x->step(s, h, 1, gravity, {})); };
            };
            QVERIFY(caseWithin("V8", fmt::format("pendulum from {}°, XPBD", row.degrees), row.ratio,
                               pendulumRatio(row.degrees, xpbd, 2.5e-5), 1e-3));
        }
    }

    void v15StretchedMembrane() {
        for (int n : {8, 16}) {
            const double lumped = std::sin(pi / (2 * n)) / (pi / (2 * n));
            QVERIFY(caseWithin("V15", fmt::format("square membrane, {} × {} cells, f11", n, n), 5.0 * lumped,
                               membraneFrequency(n), 1e-4));
        }
    }

    void v16StripVibration() {
        constexpr int cells = 32;
        constexpr double length = 0.1, h = length / cells;
        Fabric fabric = wovenFabric();
        fabric.warpStiffness = fabric.weftStiffness = 50;
        fabric.shearStiffness = 5;
        fabric.warpBending = fabric.weftBending = 5e-5;
        fabric.biasBending = 2.5e-5;
        std::vector<double> columns;
        for (int i = -1; i <= cells; ++i) columns.push_back(i * h);
        const Patch patch = gridPatch(columns, evenLines(h, 1));
        ClothModel model = modelOf(patch, fabric);
        ParticleState state;
        for (const Vec2& m : patch.material) {
            const double t = std::max(0.0, m.x / length); // near enough to the first mode to excite little else
            state.positions.push_back({m.x, m.y, -1e-5 * t * t * (3 - t) / 2});
        }
        state.velocities.resize(state.positions.size());
        for (int p = 0; p < model.particleCount(); ++p)
            if (patch.material[p].x < h / 2) model.pinned.push_back(p);
        cloth::doubleBendingAtClampedRows(model);
        dynamics::SymplecticEuler euler(model);
        const double step = 0.9 * euler.stepLimit();
        const double period = periodOf(
            [&] {
                need(euler.step(state, step, {}));
                return state.positions[cells + 1].z;
            },
            step, 1);
        QVERIFY(caseWithin("V16", "cantilever strip in zero g, 32 cells, f1",
                           3.51602 / (2 * pi * length * length) * std::sqrt(5e-5 / 0.2), 1 / period, 0.02));
    }

    void v17MomentumAndEnergyOfAKickedSheet() {
        const Fabric fabric = wovenFabric();
        Patch patch;
        const ClothModel model = sheetModel(patch, 8, fabric);
        ParticleState start{.positions = flatPositions(patch), .velocities = {}};
        start.velocities.assign(start.positions.size(), {});
        shake(start.velocities, 1, 11);
        double scale = 0, spin = 0;
        for (int p = 0; p < model.particleCount(); ++p) {
            scale += model.mass[p] * length(start.velocities[p]);
            spin += model.mass[p] * length(start.velocities[p]) * length(start.positions[p]);
        }
        const Vec3 linear = momentum(model, start), angular = angularMomentum(model, start);

        ParticleState state = start;
        dynamics::SymplecticEuler euler(model);
        const double h = 0.1 * euler.stepLimit(); // ωh = 0.2
        const int steps = static_cast<int>(10 / h);
        const auto energyOf = [&](ParticleState at) { // symplectic Euler's velocities are half a step behind
            std::vector<Vec3> forces(at.positions.size());
            cloth::addForces(model, at.positions, forces);
            for (std::size_t p = 0; p < forces.size(); ++p) at.velocities[p] += 0.5 * h / model.mass[p] * forces[p];
            return energies(model, at, {}).total();
        };
        const double before = energyOf(state);
        double largest = 0, lastSecond = 0;
        for (int i = 0; i < steps; ++i) {
            need(euler.step(state, h, {}));
            if (i % 50 != 0) continue;
            const double change = std::abs(energyOf(state) / before - 1);
            largest = std::max(largest, change);
            if (i > 0.9 * steps) lastSecond = std::max(lastSecond, change);
        }
        QVERIFY(caseBelow("V17", "symplectic Euler, 10 s: momentum, of Σm|v| per step", 1e-12,
                          length(momentum(model, state) - linear) / scale / steps));
        QVERIFY(caseBelow("V17", "symplectic Euler, 10 s: angular momentum per step", 1e-12,
                          length(angularMomentum(model, state) - angular) / spin / steps));
        QVERIFY(caseBelow("V17", "symplectic Euler, 10 s: energy error", 0.01, largest));
        QVERIFY(caseBelow("V17", "symplectic Euler, energy error in the last second", 0.01, lastSecond));

        state = start;
        dynamics::Xpbd xpbd(model, {.damping = 0});
        dynamics::EnergyMonitor monitor;
        bool warned = false;
        for (int frame = 0; frame < 120; ++frame) {
            need(xpbd.step(state, 1.0 / 60, 20, {}, {}));
            warned |= monitor.observe(energies(model, state, {}));
        }
        QVERIFY(caseBelow("V17", "XPBD, 2 s, 20 substeps: momentum per substep", 1e-12,
                          length(momentum(model, state) - linear) / scale / 2400));
        QVERIFY(caseBelow("V17", "XPBD, 2 s: energy above its start, relative", 0.01, monitor.growth() / before));
        QVERIFY(!warned);
    }

    void v18FreeFall() {
        ClothModel model;
        model.mass = {0.01};
        constexpr int n = 120;
        constexpr double h = 1.0 / 60;
        const double exact = g * h * h * n * (n + 1) / 2;
        ParticleState a{.positions = {{}}, .velocities = {{}}};
        ParticleState b = a, c = a, d = a;
        dynamics::SymplecticEuler euler(model);
        dynamics::Xpbd xpbd(model, {.damping = 0});
        dynamics::ImplicitRungeKutta implicitEuler(model, dynamics::backwardEuler(), {.tolerance = 1e-14});
        dynamics::SymplecticEuler dragged(model, {.damping = 2});
        for (int i = 0; i < n; ++i) {
            need(euler.step(a, h, gravity));
            need(xpbd.step(b, h, 1, gravity, {}));
            QVERIFY(implicitEuler.step(c, h, gravity));
        }
        QVERIFY(caseWithin("V18", "free fall, symplectic Euler, depth", exact, -a.positions[0].y, 1e-12));
        QVERIFY(caseWithin("V18", "free fall, XPBD, depth", exact, -b.positions[0].y, 1e-12));
        QVERIFY(caseWithin("V18", "free fall, backward Euler, depth", exact, -c.positions[0].y, 1e-12));
        for (int i = 0; i < 1200; ++i) need(dragged.step(d, h, gravity));
        QVERIFY(caseWithin("V18", "fall with drag 2 1/s, final speed", g / 2, -d.velocities[0].y, 1e-12));
    }
};

QTEST_APPLESS_MAIN(tst_DynamicCases)
#include "tst_DynamicCases.moc"
