// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Energy.h"
#include "core/dynamics/RungeKutta4.h"
#include "core/study/Trajectory.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Sheets.h"

#include <Eigen/Dense>
#include <fmt/format.h>
#include <numbers>

namespace toile::study::validation {
using dynamics::IntegratorSettings;
using dynamics::Method;

namespace {

constexpr double g = standardGravity, pi = std::numbers::pi;
constexpr Vec3 gravity = downward;

dynamics::StepReport run(Findings& found, dynamics::Integrator& integrator, ParticleState& state, int steps, double h,
                         const Vec3& pull) {
    dynamics::StepReport sum{.parts = 0};
    for (int i = 0; i < steps; ++i) {
        const auto done = integrator.step(state, h, pull);
        if (!found.ran(done)) break;
        sum += *done;
    }
    return sum;
}

/// One mass of 10 g on a spring of 100 N/m along x, 1 mm out of rest.
struct Oscillator {
    ClothModel model;
    ParticleState state;
    explicit Oscillator(double stiffness = 100) {
        model.mass = {0.01, 0.01};
        model.structural = {{0, 1, 1, stiffness}};
        model.pinned = {0};
        state.positions = {{0, 0, 0}, {1.001, 0, 0}};
        state.velocities.resize(2);
    }
};

/// Error of the oscillator's position after a quarter second, relative to its amplitude.
double oscillatorError(Findings& found, Method method, int steps) {
    Oscillator o;
    const auto integrator = dynamics::makeIntegrator(
        method, o.model, {.damping = 0, .substeps = 1, .stiffnessCap = 1e30, .tolerance = 1e-13});
    run(found, *integrator, o.state, steps, 0.25 / steps, {});
    return std::abs(o.state.positions[1].x - 1 - 1e-3 * std::cos(25.0)) / 1e-3;
}

struct Order {
    Method method;
    int order;
    int coarse;     ///< steps of the oscillator
    int flapCoarse; ///< steps a second of the flap
};
constexpr Order orders[] = {
    {Method::xpbd, 1, 2000, 3840},         {Method::symplecticEuler, 1, 2000, 960},
    {Method::backwardEuler, 1, 2000, 960}, {Method::baraffWitkin, 1, 2000, 960},
    {Method::midpoint, 2, 250, 480},       {Method::bdf2, 2, 1000, 480},
    {Method::trBdf2, 2, 250, 480},         {Method::rk4, 4, 250, 480},
    {Method::sdirk4, 4, 60, 120},
};

/// The flap of 8 × 8 cells after 0.2 s in so many steps a second.
std::vector<Vec3> flapAfter(Findings& found, const Scene& sheet, Method method, int perSecond,
                            IntegratorSettings settings = {}) {
    settings.damping = sheet.damping;
    settings.substeps = 1;
    ParticleState state = sheet.start;
    const auto integrator = dynamics::makeIntegrator(method, sheet.model, settings);
    run(found, *integrator, state, perSecond / 5, 1.0 / perSecond, gravity);
    return state.positions;
}

/// Frequency of a chain of links that hangs from its first particle and swings a little in one mode.
double chainFrequency(Findings& found, int links, int mode, Method method) {
    // Its shape: J0 of the mode's zero times the root of the height over the free end.
    constexpr double zeros[] = {2.404825557695773, 5.520078110286311, 8.653727912911013};
    ClothModel model;
    ParticleState state;
    model.pinned = {0};
    std::vector<double> shape;
    const double link = 1.0 / links;
    for (int i = 0; i <= links; ++i) {
        model.mass.push_back(i == links ? 0.5 * link : link); // 1 kg/m
        shape.push_back(std::cyl_bessel_j(0.0, zeros[mode] * std::sqrt(1 - i * link)));
        state.positions.push_back({1e-4 * shape[i], -i * link, 0});
        if (i > 0) model.structural.push_back({i - 1, i, link, 1e6});
    }
    state.velocities.resize(state.positions.size());
    const auto integrator = dynamics::makeIntegrator(method, model, {.damping = 0, .tolerance = 1e-9});
    const auto partOfMode = [&] {
        double sum = 0;
        for (int i = 1; i <= links; ++i) sum += model.mass[i] * shape[i] * state.positions[i].x;
        return sum;
    };
    constexpr double h = 1e-3;
    constexpr int periods = 4;
    double last = partOfMode(), first = 0;
    int falls = 0; // through 0
    for (int i = 1;; ++i) {
        run(found, *integrator, state, 1, h, gravity);
        const double now = partOfMode();
        if (last > 0 && now <= 0) {
            const double at = (i - 1 + last / (last - now)) * h;
            if (falls == 0) first = at;
            if (falls++ == periods) return periods / (at - first);
        }
        last = now;
    }
}

/// Of small swings of a chain of links, rising: K x = ω² M x with the tension of what hangs below each link.
std::vector<double> chainFrequencies(int links) {
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(links, links), mass = stiffness;
    const double link = 1.0 / links;
    for (int i = 0; i < links; ++i) {
        mass(i, i) = i == links - 1 ? 0.5 * link : link;
        const double pull = g * (1 - (i + 0.5) * link) / link;
        stiffness(i, i) += pull;
        if (i == 0) continue;
        stiffness(i - 1, i - 1) += pull;
        stiffness(i, i - 1) -= pull;
        stiffness(i - 1, i) -= pull;
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass);
    std::vector<double> frequencies;
    for (int i = 0; i < links; ++i) frequencies.push_back(std::sqrt(solver.eigenvalues()[i]) / (2 * pi));
    return frequencies;
}

void v1Frequencies(Findings& found) {
    Oscillator o;
    const auto integrator = dynamics::makeIntegrator(Method::trBdf2, o.model, {.damping = 0, .tolerance = 1e-12});
    constexpr double h = 1e-3; // ωh = 0.1
    double last = o.state.positions[1].x - 1, first = 0;
    int crossings = 0;
    for (int i = 1; crossings <= 10; ++i) {
        run(found, *integrator, o.state, 1, h, {});
        const double now = o.state.positions[1].x - 1;
        if (last < 0 && now >= 0) {
            const double at = (i - now / (now - last)) * h;
            if (crossings == 0) first = at;
            if (crossings == 10)
                found.within("oscillator, TR-BDF2 at ωh=0.1, frequency", 15.9155, 10 / (at - first), 1e-3);
            ++crossings;
        }
        last = now;
    }
}

void v2OrdersOnTheOscillator(Findings& found) {
    for (const Order& row : orders) {
        const double slope = std::log2(oscillatorError(found, row.method, row.coarse) /
                                       oscillatorError(found, row.method, 8 * row.coarse)) /
                             3;
        found.within(fmt::format("oscillator, order of {}", dynamics::nameOf(row.method)), row.order, slope,
                     (row.order == 4 ? 0.3 : 0.15) / row.order);
    }
}

void v2OrdersOnTheFlap(Findings& found) {
    const Scene sheet = *sceneNamed("flap", {8, 1});
    const auto reference = flapAfter(found, sheet, Method::rk4, 19200);
    for (const Order& row : orders) {
        const IntegratorSettings settings{.stiffnessCap = 1e30, .tolerance = 1e-10, .gradientIterations = 0};
        const auto errorAt = [&](int perSecond) {
            return rmsDistance(sheet, flapAfter(found, sheet, row.method, perSecond, settings), reference);
        };
        const double slope = std::log2(errorAt(row.flapCoarse) / errorAt(4 * row.flapCoarse)) / 2;
        found.within(fmt::format("flap, order of {}", dynamics::nameOf(row.method)), row.order, slope,
                     (row.order == 4 ? 0.3 : 0.15) / row.order);
    }
}

void v2OrdersOnTheStiffFlap(Findings& found) {
    // Steps that do not resolve the waves of the cloth: ωh from 14 at 1/240 s and factor 1 to 1400.
    double error[3] = {};
    int at = 0;
    for (const double factor : {1.0, 1e2, 1e4}) {
        const Scene sheet = *sceneNamed("flap", {8, factor});
        const auto reference =
            flapAfter(found, sheet, Method::trBdf2, 3840, {.tolerance = 1e-8, .gradientIterations = 0});
        const auto errorAt = [&](int perSecond) {
            return rmsDistance(sheet, flapAfter(found, sheet, Method::trBdf2, perSecond, {.tolerance = 1e-6}),
                               reference);
        };
        const double coarse = errorAt(60), fine = errorAt(240);
        error[at++] = coarse;
        found.atMost(fmt::format("TR-BDF2 on the flap × {:g}: 2 − order, 1/60 to 1/240 s", factor), 1,
                     2 - std::log2(coarse / fine) / 2);
    }
    const auto [least, most] = std::minmax({error[0], error[1], error[2]});
    found.atMost("TR-BDF2 at 1/60 s: largest over least error, × 1 to × 1e4", 2, most / least);
}

void v8bHangingChain(Findings& found) {
    constexpr double continuum[] = {0.5994, 1.3758, 2.1569};
    const std::vector<double> discrete = chainFrequencies(32);
    for (int mode = 0; mode < 3; ++mode) {
        const double measured = chainFrequency(found, 32, mode, Method::trBdf2);
        found.within(fmt::format("chain of 32 links, f{} by TR-BDF2, of 32 links", mode + 1), discrete[mode], measured,
                     1e-3);
        if (mode < 2)
            found.within(fmt::format("the same, of a chain without links", mode + 1), continuum[mode], measured, 0.01);
    }
    found.within("chain of 64 links, f3, of a chain without links", continuum[2],
                 chainFrequency(found, 64, 2, Method::trBdf2), 0.01);
}

void v17EnergyOfAKickedSheet(Findings& found) {
    Patch patch = gridPatch(evenLines(0.2, 8), evenLines(0.2, 8));
    const ClothModel model = modelOf(patch, unequalWeave());
    ParticleState start{.positions = flatPositions(patch), .velocities = {}};
    start.velocities = kickOf(start.positions.size());
    double scale = 0;
    for (std::size_t p = 0; p < model.mass.size(); ++p) scale += model.mass[p] * length(start.velocities[p]);
    const double before = energies(model, start, {}).total();
    struct Row {
        Method method;
        double allowed;
    };
    for (const Row& row : {Row{Method::backwardEuler, 0.001}, {Method::trBdf2, 0.01}, {Method::bdf2, 0.01}}) {
        ParticleState state = start;
        const auto integrator = dynamics::makeIntegrator(row.method, model, {.damping = 0, .tolerance = 1e-6});
        double most = before;
        for (int i = 0; i < 600; ++i) {
            run(found, *integrator, state, 1, 1.0 / 60, {});
            most = std::max(most, energies(model, state, {}).total());
        }
        const std::string name(dynamics::nameOf(row.method));
        found.atMost(fmt::format("{}, 10 s at 1/60 s: energy above its start", name), row.allowed, most / before - 1);
        found.atMost(fmt::format("{}, 10 s: momentum, of Σm|v|", name), 1e-4,
                     length(momentum(model, state) - momentum(model, start)) / scale);
    }
}

} // namespace

std::vector<Case> integratorCases() {
    constexpr std::string_view theme = "integrators";
    return {
        {"V1", theme, "oscillator by TR-BDF2", v1Frequencies},
        {"V2", theme, "orders on the oscillator", v2OrdersOnTheOscillator},
        {"V2", theme, "orders on the flap", v2OrdersOnTheFlap},
        {"V2", theme, "TR-BDF2 on the stiff flap", v2OrdersOnTheStiffFlap},
        {"V8b", theme, "hanging chain", v8bHangingChain},
        {"V17", theme, "energy of a kicked sheet, implicit methods", v17EnergyOfAKickedSheet},
    };
}

} // namespace toile::study::validation
