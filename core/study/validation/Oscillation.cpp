// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/Energy.h"
#include "core/dynamics/ImplicitRungeKutta.h"
#include "core/dynamics/Method.h"
#include "core/dynamics/StrainDamping.h"
#include "core/dynamics/SymplecticEuler.h"
#include "core/dynamics/Xpbd.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Sheets.h"

#include <fmt/format.h>
#include <functional>
#include <memory>

namespace toile::study::validation {

namespace {

constexpr double g = standardGravity, pi = std::numbers::pi;
constexpr Vec3 gravity = downward;

/// Mean time between rising zero crossings of a signal sampled every h, over `count` periods.
double periodOf(Findings& found, const std::function<double()>& nextSample, double h, int count) {
    double last = nextSample(), first = 0;
    int crossings = 0;
    for (long sample = 1; sample < 50'000'000 && !found.stopped(); ++sample) {
        const double now = nextSample();
        if (last < 0 && now >= 0) {
            const double at = (static_cast<double>(sample) - now / (now - last)) * h;
            if (crossings == 0) first = at;
            if (crossings == count) return (at - first) / count;
            ++crossings;
        }
        last = now;
    }
    found.stop("The signal does not oscillate.");
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

Step implicit(Findings& found, const ClothModel& model) {
    auto euler = std::make_shared<dynamics::ImplicitRungeKutta>(model, dynamics::backwardEuler(),
                                                                dynamics::ImplicitSettings{.tolerance = 1e-12});
    return [&found, euler](ParticleState& s, double h) { found.ran(euler->step(s, h, {})); };
}

/// V8: a mass on a stiff spring of length 1, let go at an angle. Period over that of small swings.
double pendulumRatio(Findings& found, double degrees, const std::function<Step(const ClothModel&)>& makeStep,
                     double h) {
    ClothModel model;
    model.mass = {1, 1};
    model.structural = {{0, 1, 1, 1e6}};
    model.pinned = {0};
    const double angle = degrees * pi / 180;
    ParticleState state{.positions = {{0, 0, 0}, {std::sin(angle), -std::cos(angle), 0}}, .velocities = {{}, {}}};
    const Step step = makeStep(model);
    const double period = periodOf(
        found,
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
double membraneFrequency(Findings& found, int n) {
    constexpr double tension = 10, stiffness = 1000, density = 0.2;
    const double strain =
        tension / (stiffness - tension); // E·e/(1 + e) = T: stiffness per rest width, load per real one
    const double side = 1 / (1 + strain);
    Fabric fabric = unequalWeave();
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
                   found,
                   [&] {
                       found.ran(euler.step(state, h, {}));
                       return state.positions[middle].z;
                   },
                   h, 2);
}

void v1OscillatorFrequency(Findings& found) {
    Oscillator o = oscillator(1e-3);
    dynamics::SymplecticEuler euler(o.model);
    const double period = periodOf(
        found,
        [&] {
            found.ran(euler.step(o.state, 1e-4, {}));
            return o.state.positions[1].x - 1;
        },
        1e-4, 10);
    found.within("oscillator, symplectic Euler at 1e-4 s, frequency", 15.9155, 1 / period, 1e-4);

    Oscillator x = oscillator(1e-3);
    dynamics::Xpbd xpbd(x.model, {.damping = 0, .stiffnessCap = 1e9});
    const double xpbdPeriod = periodOf(
        found,
        [&] {
            found.ran(xpbd.step(x.state, 1e-5, 1, {}, {}));
            return x.state.positions[1].x - 1;
        },
        1e-5, 3);
    found.within("oscillator, XPBD at 1e-5 s, frequency", 15.9155, 1 / xpbdPeriod, 1e-4);
}

void v1ImplicitEulerDampsByItsFormula(Findings& found) {
    constexpr double h = 1e-3, ratio = 100 * h; // ωh = 0.1
    Oscillator o = oscillator(1e-3);
    const Step step = implicit(found, o.model);
    const auto energy = [&] {
        const double x = o.state.positions[1].x - 1, v = o.state.velocities[1].x;
        return 0.5 * 100 * x * x + 0.5 * 0.01 * v * v;
    };
    const double before = energy();
    for (int i = 0; i < 10; ++i) step(o.state, h);
    const double measured = std::pow(energy() / before, 0.5 / 10); // amplitude per step
    found.within("oscillator, backward Euler at ωh=0.1, damping a step", 1 / std::sqrt(1 + ratio * ratio), measured,
                 1e-6);
}

/// The spring has a damper c beside it: c = βk. A² = x² + ((v + ζωx)/ω_d)² falls with e^(−2ζωt), at any time.
void v1OscillatorWithADamper(Findings& found) {
    constexpr double k = 100, m = 0.01, ratio = 0.2; // ζ
    const double free = std::sqrt(k / m), damped = free * std::sqrt(1 - ratio * ratio);
    const auto amplitude = [&](const ParticleState& state) {
        const double x = state.positions[1].x - 1, v = state.velocities[1].x;
        return std::hypot(x, (v + ratio * free * x) / damped);
    };
    struct Row {
        dynamics::Method method;
        double step, tolerance;
    };
    for (const Row& row : {Row{dynamics::Method::rk4, 1e-4, 1e-4}, Row{dynamics::Method::trBdf2, 5e-4, 1e-3},
                           Row{dynamics::Method::xpbd, 1e-6, 1e-3}}) {
        Oscillator o = oscillator(1e-3);
        dynamics::StrainDamping damper(o.model, 2 * ratio / free, o.state.positions);
        dynamics::Stage* const stages[] = {&damper};
        const auto integrator = dynamics::makeIntegrator(
            row.method, o.model, {.damping = 0, .substeps = 1, .stiffnessCap = 1e9, .tolerance = 1e-12});
        const double before = amplitude(o.state);
        const double period = periodOf(
            found,
            [&] {
                found.ran(integrator->step(o.state, row.step, {}, stages));
                return o.state.positions[1].x - 1;
            },
            row.step, 3);
        const std::string by =
            fmt::format("oscillator with ζ = {}, {} at {:g} s: ", ratio, nameOf(row.method), row.step);
        found.within(by + "frequency", damped / (2 * pi), 1 / period, row.tolerance);
        found.within(by + "decay [1/s]", ratio * free, std::log(before / amplitude(o.state)) / o.state.time,
                     row.tolerance);
    }
}

void v8PendulumPeriods(Findings& found) {
    struct Row {
        double degrees, ratio;
    };
    for (const Row& row : {Row{10, 1.0019072}, {45, 1.0399733}, {90, 1.1803406}, {150, 1.7622037}}) {
        const auto euler = [&found](const ClothModel& model) -> Step {
            auto e = std::make_shared<dynamics::SymplecticEuler>(model);
            return [&found, e](ParticleState& s, double h) { found.ran(e->step(s, h, gravity)); };
        };
        found.within(fmt::format("pendulum from {}°, symplectic Euler", row.degrees), row.ratio,
                     pendulumRatio(found, row.degrees, euler, 2e-4), 1e-3);
        if (row.degrees > 90) continue; // XPBD loses energy by O(h), and there the period depends most on it
        const auto xpbd = [&found](const ClothModel& model) -> Step {
            auto x = std::make_shared<dynamics::Xpbd>(model, dynamics::XpbdSettings{.damping = 0});
            return [&found, x](ParticleState& s, double h) { found.ran(x->step(s, h, 1, gravity, {})); };
        };
        found.within(fmt::format("pendulum from {}°, XPBD", row.degrees), row.ratio,
                     pendulumRatio(found, row.degrees, xpbd, 2.5e-5), 1e-3);
    }
}

void v15StretchedMembrane(Findings& found) {
    for (int n : {8, 16}) {
        const double lumped = std::sin(pi / (2 * n)) / (pi / (2 * n));
        found.within(fmt::format("square membrane, {} × {} cells, f11", n, n), 5.0 * lumped,
                     membraneFrequency(found, n), 1e-4);
    }
}

void v16StripVibration(Findings& found) {
    constexpr int cells = 32;
    constexpr double length = 0.1, h = length / cells;
    Fabric fabric = unequalWeave();
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
        found,
        [&] {
            found.ran(euler.step(state, step, {}));
            return state.positions[cells + 1].z;
        },
        step, 1);
    found.within("cantilever strip in zero g, 32 cells, f1",
                 3.51602 / (2 * pi * length * length) * std::sqrt(5e-5 / 0.2), 1 / period, 0.02);
}

void v17MomentumAndEnergyOfAKickedSheet(Findings& found) {
    const Fabric fabric = unequalWeave();
    Patch patch;
    const ClothModel model = sheetModel(patch, 8, fabric);
    ParticleState start{.positions = flatPositions(patch), .velocities = {}};
    start.velocities = kickOf(start.positions.size());
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
        found.ran(euler.step(state, h, {}));
        if (i % 50 != 0) continue;
        const double change = std::abs(energyOf(state) / before - 1);
        largest = std::max(largest, change);
        if (i > 0.9 * steps) lastSecond = std::max(lastSecond, change);
    }
    found.atMost("symplectic Euler, 10 s: momentum, of Σm|v| per step", 1e-12,
                 length(momentum(model, state) - linear) / scale / steps);
    found.atMost("symplectic Euler, 10 s: angular momentum per step", 1e-12,
                 length(angularMomentum(model, state) - angular) / spin / steps);
    found.atMost("symplectic Euler, 10 s: energy error", 0.01, largest);
    found.atMost("symplectic Euler, energy error in the last second", 0.01, lastSecond);

    state = start;
    dynamics::Xpbd xpbd(model, {.damping = 0});
    dynamics::EnergyMonitor monitor;
    bool warned = false;
    for (int frame = 0; frame < 120; ++frame) {
        found.ran(xpbd.step(state, 1.0 / 60, 20, {}, {}));
        warned |= monitor.observe(energies(model, state, {}));
    }
    found.atMost("XPBD, 2 s, 20 substeps: momentum per substep", 1e-12,
                 length(momentum(model, state) - linear) / scale / 2400);
    found.atMost("XPBD, 2 s: energy above its start, relative", 0.01, monitor.growth() / before);
    if (warned) found.stop("The monitor saw energy that no one put in.");
}

void v18FreeFall(Findings& found) {
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
        found.ran(euler.step(a, h, gravity));
        found.ran(xpbd.step(b, h, 1, gravity, {}));
        found.ran(implicitEuler.step(c, h, gravity));
    }
    found.within("free fall, symplectic Euler, depth", exact, -a.positions[0].y, 1e-12);
    found.within("free fall, XPBD, depth", exact, -b.positions[0].y, 1e-12);
    found.within("free fall, backward Euler, depth", exact, -c.positions[0].y, 1e-12);
    for (int i = 0; i < 1200; ++i) found.ran(dragged.step(d, h, gravity));
    found.within("fall with drag 2 1/s, final speed", g / 2, -d.velocities[0].y, 1e-12);
}

} // namespace

std::vector<Case> oscillationCases() {
    constexpr std::string_view theme = "oscillation";
    return {
        {"V1", theme, "oscillator: frequency", v1OscillatorFrequency},
        {"V1", theme, "oscillator: numerical damping", v1ImplicitEulerDampsByItsFormula},
        {"V1", theme, "oscillator: damper", v1OscillatorWithADamper},
        {"V8", theme, "pendulum", v8PendulumPeriods},
        {"V15", theme, "stretched membrane", v15StretchedMembrane},
        {"V16", theme, "vibrating strip", v16StripVibration},
        {"V17", theme, "momentum and energy of a kicked sheet", v17MomentumAndEnergyOfAKickedSheet},
        {"V18", theme, "free fall", v18FreeFall},
    };
}

} // namespace toile::study::validation
