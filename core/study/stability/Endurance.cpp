// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Statics.h"
#include "core/geometry/Shapes.h"
#include "core/simulation/Simulation.h"
#include "core/study/Calibration.h"
#include "core/study/Scenes.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>

/// The same for long, and the same again.
namespace toile::study::stability {
namespace {

using dynamics::Method;
using dynamics::ParticleState;

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double most = 0;
    for (std::size_t p = 0; p < a.size(); ++p) most = std::max(most, geometry::distance(a[p], b[p]));
    return most;
}

/// A sheet that hangs by two corners, brought to rest by the method itself where it is not that of statics.
Findings hangingAtRest(const Effort& effort) {
    Findings found;
    const int steps = effort.quick ? 5000 : 100000;
    for (const Method method : {Method::trBdf2, Method::symplecticEuler, Method::xpbd}) {
        Scene scene = *sceneNamed("two-corners", {4, 1});
        ParticleState state = scene.start;
        const auto rest = dynamics::solveStatic(scene.model, state, scene.gravity, {},
                                                {.tolerance = 1e-9, .maximumIterations = 3000});
        if (!rest) {
            found.rows.push_back(tested("S23", "statics of a hanging sheet", false, rest.error().text));
            continue;
        }
        WatchSettings settings{method, {.damping = 0.5, .substeps = 20, .tolerance = 1e-8}, 1.0 / 240, steps};
        settings.timeLimit = effort.quick ? 15 : 300;
        if (method == Method::xpbd) { // its rest is its own: forces travel a finite way in a substep
            WatchSettings settling = settings;
            settling.integrator.damping = 5;
            settling.steps = 4000;
            static_cast<void>(watched(scene.model, state, settling));
        }
        state.velocities.assign(state.positions.size(), {});
        const std::vector<Vec3> start = state.positions;
        const Watched run = watched(scene.model, state, settings);
        const double drift = farthest(start, state.positions);
        Row row = judged("S23", fmt::format("{} steps at rest, {}: drift {:.2g} m", run.steps, nameOf(method), drift),
                         run, method);
        row.metrics.energyGrowth.reset(); // nothing is turned over
        if (run.stopped.empty() && run.solved)
            row = tested(row.number, row.what, drift <= 1e-6, "More than 1e-6 m.", row.metrics);
        found.rows.push_back(std::move(row));
    }
    return found;
}

/// A sheet that is let down on a table.
simulation::Scene sheetOnTable() {
    simulation::Scene scene;
    scene.pattern.fabrics.push_back(validation::plainCloth());
    pattern::Piece sheet = validation::polygonPiece("sheet", {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0, 0.3}}, 0.03);
    sheet.placement = pattern::Placement{};
    sheet.placement->transform = {.axisX = {1, 0, 0}, .axisY = {0, 0, -1}, .axisZ = {0, 1, 0}};
    sheet.placement->transform.origin = {-0.15, 0.01, 0.15};
    scene.pattern.pieces.push_back(std::move(sheet));
    body::Body table;
    table.mesh = geometry::box({-0.5, -0.5, -0.5}, {0.5, 0, 0.5});
    scene.body = Shared<body::Body>(std::move(table));
    return scene;
}

/// What lies still on a body sleeps, and from then on no bit of it changes.
Row asleep(int steps) {
    const double start = threadSeconds();
    auto made = simulation::Simulation::create(sheetOnTable());
    std::string why = made ? "" : made.error().text;
    std::vector<Vec3> whereItSlept;
    int awake = 0;
    for (int step = 0; step < steps && why.empty(); ++step) {
        const double sleptBefore = made->sleptTime();
        if (const auto advanced = made->advance(); !advanced) why = advanced.error().text;
        else if (made->sleptTime() == sleptBefore) ++awake;
        else if (whereItSlept.empty()) whereItSlept = made->state().positions;
    }
    if (why.empty() && whereItSlept.empty()) why = "It never sleeps.";
    const double drift = why.empty() ? farthest(whereItSlept, made->state().positions) : 0;
    if (drift > 0) why = "It moved again.";
    return tested("S23", fmt::format("{} frame steps on a table, asleep after {}: drift {:g} m", steps, awake, drift),
                  why.empty(), why, {.seconds = threadSeconds() - start});
}

Findings s23AtRest(const Effort& effort) {
    Findings found = hangingAtRest(effort);
    found.rows.push_back(asleep(effort.quick ? 5000 : 100000));
    return found;
}

Findings s26Again(const Effort&) {
    Findings found;
    for (const Method method : dynamics::allMethods()) {
        std::vector<Vec3> ends[2];
        for (auto& end : ends) {
            Scene scene = *sceneNamed("flap", {8, 100});
            static_cast<void>(
                watched(scene.model, scene.start, {.method = method, .integrator = {.substeps = 20}, .steps = 12}));
            end = scene.start.positions;
        }
        found.rows.push_back(tested("S26", fmt::format("the same bits twice, {}", nameOf(method)),
                                    std::memcmp(ends[0].data(), ends[1].data(), ends[0].size() * sizeof(Vec3)) == 0,
                                    "Two equal runs differ."));
    }
    return found;
}

} // namespace

std::vector<Case> enduranceCases() {
    return {{"S23", "long at rest", s23AtRest}, {"S26", "repeatable", s26Again}};
}

} // namespace toile::study::stability
