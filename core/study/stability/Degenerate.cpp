// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/pattern/PatternCheck.h"
#include "core/simulation/Sew.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <random>

/// Cloth without mass, length, area or order, and steps that are none.
namespace toile::study::stability {
namespace {

using cloth::ClothModel;
using dynamics::Method;
using dynamics::ParticleState;
using validation::polygonPiece;

constexpr Vec3 weightless{};

/// Two particles of 10 g and what is between them.
struct Pair {
    ClothModel model;
    ParticleState state;

    Pair(double restLength, double apart) {
        model.mass = {0.01, 0.01};
        model.structural = {{0, 1, restLength, 100}};
        state.positions = {{0, 0, 0}, {apart, 0, 0}};
        state.velocities.resize(2);
    }
    [[nodiscard]] double distance() const { return geometry::distance(state.positions[0], state.positions[1]); }
};

Findings s4NoMass(const Effort&) {
    Pair pair(0.1, 0.1);
    pair.model.mass[1] = 0;
    return {{mustBeRefused("S4", "a free particle without mass", watched(pair.model, pair.state, {}).stopped)}, {}};
}

Findings s5NoLength(const Effort&) {
    Findings found;
    for (const Method method : {Method::xpbd, Method::trBdf2, Method::symplecticEuler})
        for (const double apart : {0.0, 0.1}) {
            Pair pair(0, apart);
            found.rows.push_back(judged("S5", fmt::format("spring of no length, {} m apart, {}", apart, nameOf(method)),
                                        watched(pair.model, pair.state, {.method = method, .gravity = weightless}),
                                        method));
        }
    return found;
}

Findings s6InOnePlace(const Effort&) {
    Findings found;
    for (const Method method : {Method::xpbd, Method::trBdf2, Method::symplecticEuler}) {
        Pair pair(0.1, 0);
        const Watched run =
            watched(pair.model, pair.state, {.method = method, .integrator = {.damping = 2}, .gravity = weightless});
        Row row =
            judged("S6", fmt::format("both ends of a spring of 0.1 m in one place, {}", nameOf(method)), run, method);
        if (row.verdict == Verdict::pass && pair.distance() < 0.05)
            row = tested(
                row.number, row.what, false,
                fmt::format("They stay {:.2g} m apart: a spring without a direction does not push.", pair.distance()),
                row.metrics);
        found.rows.push_back(std::move(row));
    }
    return found;
}

/// A sheet of 0.1 m, every particle in one place or anywhere in a box of its size.
Findings s7WithoutOrder(const Effort&) {
    Findings found;
    const cloth::Patch patch = cloth::gridPatch(cloth::evenLines(0.1, 8), cloth::evenLines(0.1, 8));
    const ClothModel model = validation::modelOf(patch, validation::unequalWeave());
    for (const double box : {0.1, 0.0})
        for (const Method method : {Method::xpbd, Method::backwardEuler, Method::trBdf2}) {
            std::mt19937 random(3);
            const auto deviate = [&] { return box * (static_cast<double>(random()) / std::mt19937::max() - 0.5); };
            ParticleState state;
            for (int p = 0; p < model.particleCount(); ++p) {
                const double x = deviate(), y = deviate(), z = deviate();
                state.positions.push_back({x, y, z});
            }
            const double before = cloth::energy(model, state.positions);
            const Watched run = watched(
                model, state, {.method = method, .integrator = {.damping = 2}, .steps = 120, .gravity = weightless});
            const double left = cloth::energy(model, state.positions) / before;
            Row row = judged("S7",
                             fmt::format("sheet with all particles {}, {}: {:.2g} of the elastic energy left after 2 s",
                                         box > 0 ? "at random in a box" : "in one place", nameOf(method), left),
                             run, method);
            if ((row.verdict == Verdict::pass || row.verdict == Verdict::passWithWarning) && left > 0.01)
                row = tested(row.number, row.what, false, "It does not recover.", row.metrics);
            found.rows.push_back(std::move(row));
        }
    return found;
}

/// Two triangles over a base of 1 cm, the second as flat as is asked. One without any area cannot be made: the mesher
/// refuses it (S9).
Row flatTriangle(const std::string& what, double height) {
    cloth::Patch patch;
    patch.material = {{0, 0}, {0.01, 0}, {0.005, 0.01}, {0.005, -height}};
    patch.particles = {0, 1, 2, 3};
    patch.triangles = {{{0, 1, 2}, {}}, {{1, 0, 3}, {}}};
    ClothModel model;
    const auto done = cloth::appendPatch(model, patch, validation::unequalWeave());
    if (!done) return mustBeRefused("S8", what, done.error().text);
    const double limit = 2 / std::sqrt(cloth::largestFrequencySquared(model, cloth::flatPositions(patch)));
    model.pinned = {2};
    ParticleState state{.positions = cloth::flatPositions(patch), .velocities = {}};
    return judged("S8", fmt::format("{}: limit of explicit steps {:.2g} s; TR-BDF2", what, limit),
                  watched(model, state, {.steps = 30}), Method::trBdf2);
}

Findings s8Slivers(const Effort&) {
    const double angle = 1e-3 * std::numbers::pi / 180;
    return {{flatTriangle("triangle with angles of a thousandth of a degree", 0.005 * std::tan(angle))}, {}};
}

simulation::Scene sceneOf(pattern::Piece piece) {
    simulation::Scene scene;
    scene.pattern.fabrics.push_back(validation::plainCloth());
    scene.pattern.pieces.push_back(std::move(piece));
    return scene;
}

Row advanced(std::string number, std::string what, const simulation::Scene& scene, int frames) {
    auto simulation = simulation::Simulation::create(scene);
    if (!simulation) return tested(std::move(number), std::move(what), false, simulation.error().text);
    for (int frame = 0; frame < frames; ++frame)
        if (const auto done = simulation->advance(); !done)
            return tested(std::move(number), std::move(what), false, done.error().text);
    return tested(std::move(number), std::move(what), true, "");
}

Findings s9TooSmall(const Effort&) {
    Findings found;
    const auto line = sceneOf(polygonPiece("line", {{0, 0}, {0.1, 0}, {0.2, 0}}, 0.02));
    const auto problems = pattern::checkPattern(line.pattern);
    const auto problem = std::ranges::find_if(problems, &pattern::Problem::isError);
    found.rows.push_back(mustBeRefused("S9", "piece without area", problem == problems.end() ? "" : problem->text));
    found.rows.push_back(advanced("S9", "piece of one cell, a second",
                                  sceneOf(polygonPiece("cell", {{0, 0}, {0.02, 0}, {0.02, 0.02}, {0, 0.02}}, 0.02)),
                                  60));
    for (const Method method : {Method::xpbd, Method::trBdf2, Method::symplecticEuler}) {
        ClothModel model;
        model.mass = {0.01};
        ParticleState state{.positions = {{}}, .velocities = {{}}};
        found.rows.push_back(judged("S9", fmt::format("one particle, {}", nameOf(method)),
                                    watched(model, state, {.method = method}), method));
    }
    return found;
}

Findings s21NoStep(const Effort&) {
    Findings found;
    const double notANumber = std::numeric_limits<double>::quiet_NaN();
    for (const Method method : {Method::xpbd, Method::trBdf2, Method::symplecticEuler})
        for (const double step : {0.0, -1.0, 1e9, notANumber}) {
            Pair pair(0.1, 0.1);
            found.rows.push_back(
                mustBeRefused("S21", fmt::format("step of {} s, {}", step, nameOf(method)),
                              watched(pair.model, pair.state, {.method = method, .step = step, .steps = 1}).stopped));
        }
    auto simulation = simulation::Simulation::create(validation::twoSquares());
    if (!simulation) return found;
    const std::vector<Vec3> before = simulation->nodePositions();
    const auto report = simulation::sew(*simulation, {.seconds = 0});
    found.rows.push_back(tested("S21", "sewing for 0 s gives the start back",
                                report.has_value() && simulation->nodePositions() == before,
                                report ? "" : report.error().text));
    return found;
}

} // namespace

std::vector<Case> degenerateCases() {
    return {{"S4", "no mass", s4NoMass},        {"S5", "no length", s5NoLength}, {"S6", "in one place", s6InOnePlace},
            {"S7", "no order", s7WithoutOrder}, {"S8", "slivers", s8Slivers},    {"S9", "too small", s9TooSmall},
            {"S21", "no step", s21NoStep}};
}

} // namespace toile::study::stability
