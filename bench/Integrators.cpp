// SPDX-License-Identifier: GPL-3.0-or-later
// Work and precision of the integrators on the flap (core/study/Scenes.h): the error at 0.4 s against the
// same mesh at a far smaller step, and the cost in units of symplectic Euler near its stability limit on the
// same flap.
//
//   toile-bench-integrators [CELLS [FACTOR...]]      default: 32 cells, factors 1, 100, 10000
#include "core/cloth/Flexion.h"
#include "core/dynamics/RungeKutta4.h"
#include "core/study/Trajectory.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fmt/format.h>
#include <optional>
#include <string>

using namespace toile;
using dynamics::Method;
using study::Scene;

namespace {

constexpr double duration = 0.4, flapDamping = 0.5; // [s], [1/s]: as the scene has them
const Vec3 gravity{0, -9.81, 0};

struct Run {
    std::vector<Vec3> positions;
    dynamics::StepReport report;
    double seconds = 0; ///< of this thread's processor time; the least of the repetitions
};

double threadSeconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Setup {
    Method method = Method::trBdf2;
    double step = 1.0 / 60;
    dynamics::IntegratorSettings settings{.damping = flapDamping};
};

Run run(const Scene& flap, const Setup& setup, int repetitions) {
    Run best;
    for (int r = 0; r < repetitions; ++r) {
        const double start = threadSeconds();
        const auto integrator = dynamics::makeIntegrator(setup.method, flap.model, setup.settings);
        dynamics::ParticleState state = flap.start;
        dynamics::StepReport sum{.parts = 0};
        const int steps = static_cast<int>(std::lround(duration / setup.step));
        for (int i = 0; i < steps; ++i) {
            const auto done = integrator->step(state, duration / steps, gravity);
            if (!done) {
                fmt::print(stderr, "{}\n", toString(done.error()));
                std::exit(1);
            }
            sum += *done;
        }
        const double seconds = threadSeconds() - start;
        if (r == 0 || seconds < best.seconds) best = {state.positions, sum, seconds};
    }
    return best;
}

void printRow(const std::string& what, const Scene& flap, const Run& result, const std::vector<Vec3>& reference,
              double unit) {
    fmt::print("| {:<44} | {:>10.4g} | {:>7.3f} | {:>6.1f} | {:>6} | {:>5} | {:>5} | {:>6} | {} |\n", what,
               1000 * rmsDistance(flap, result.positions, reference), result.seconds, result.seconds / unit,
               result.report.parts, result.report.newtonIterations, result.report.factorizations,
               result.report.gradientIterations, result.report.accurate ? "" : "not solved");
    std::fflush(stdout);
}

void compare(int cells, double factor, bool quick) {
    const Scene sheet = *study::sceneNamed("flap", {cells, factor});
    fmt::print("\nflap, {} × {} particles, E = {:g} N/m\n\n", cells + 1, cells + 1, 50 * factor);
    const auto reference = [&] {
        // RK4 at 0.6 of its limit where that is affordable.
        if (factor <= 1e4) return run(sheet, {Method::rk4, duration / 24}, 1).positions;
        dynamics::IntegratorSettings tight{.damping = flapDamping, .tolerance = 1e-6};
        return run(sheet, {Method::trBdf2, 0.002, tight}, 1).positions;
    }();
    fmt::print("| method | error mm | CPU s | ratio | parts | Newton | factors | gradients | "
               "|\n|---|---|---|---|---|---|---|---|---|\n");
    const Run euler = run(sheet, {Method::symplecticEuler, duration / 24}, quick ? 1 : 3);
    printRow("symplectic Euler, 0.9 of its limit", sheet, euler, reference, euler.seconds);
    Scene paper = sheet;
    (void)cloth::flexionInsteadOfBending(paper.model, 5); // a radius of 0.2 m
    printRow("symplectic Euler, flexion springs", sheet, run(paper, {Method::symplecticEuler, duration / 24}, 1),
             reference, euler.seconds);
    const auto row = [&](const std::string& what, const Setup& setup) {
        printRow(what, sheet, run(sheet, setup, quick ? 1 : 3), reference, euler.seconds);
    };
    const auto implicitRows = [&](Method method, std::initializer_list<int> perSecond) {
        for (const int n : perSecond) row(fmt::format("{}, 1/{} s", dynamics::nameOf(method), n), {method, 1.0 / n});
    };
    implicitRows(Method::trBdf2, {60, 120, 240});
    row("trbdf2, 1/60 s, factor only", {Method::trBdf2, 1.0 / 60, {.damping = flapDamping, .gradientIterations = 0}});
    for (const double tolerance : {1e-3, 1e-4, 1e-5})
        row(fmt::format("trbdf2, adaptive to {:g} mm a part", 1000 * tolerance),
            {Method::trBdf2, 1.0 / 60, {.damping = flapDamping, .positionTolerance = tolerance}});
    implicitRows(Method::bdf2, {60, 120, 240});
    implicitRows(Method::backwardEuler, {60, 240});
    implicitRows(Method::baraffWitkin, {60, 240});
    if (factor <= 100) {
        implicitRows(Method::midpoint, {60, 240});
        implicitRows(Method::sdirk4, {60, 240});
    }
    for (const int substeps : {10, 40, 160}) {
        row(fmt::format("xpbd, {} substeps of 1/60 s", substeps),
            {Method::xpbd, 1.0 / 60, {.damping = flapDamping, .substeps = substeps}});
        row(fmt::format("xpbd without cap, {} substeps", substeps),
            {Method::xpbd, 1.0 / 60, {.damping = flapDamping, .substeps = substeps, .stiffnessCap = 1e30}});
    }
}

} // namespace

int main(int argc, char** argv) {
    const int cells = argc > 1 ? std::atoi(argv[1]) : 32;
    std::vector<double> factors;
    for (int i = 2; i < argc; ++i) factors.push_back(std::atof(argv[i]));
    if (factors.empty()) factors = {1, 100, 1e4};
    for (const double factor : factors) compare(cells, factor, factor > 100);
    return 0;
}
