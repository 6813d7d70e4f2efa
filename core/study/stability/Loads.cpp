// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/Statics.h"
#include "core/pattern/PatternCheck.h"
#include "core/study/Calibration.h"
#include "core/study/Scenes.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Pieces.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <random>

/// Cloth that is squeezed, torn at, or lacks a stiffness.
namespace toile::study::stability {
namespace {

using cloth::ClothModel;
using dynamics::Method;
using dynamics::ParticleState;
using validation::downward;

/// A sheet of 0.2 m in its plane, held at its left and right side, x scaled.
struct HeldSheet {
    static constexpr int cells = 12;
    cloth::Patch patch = cloth::gridPatch(cloth::evenLines(0.2, cells), cloth::evenLines(0.2, cells));
    ClothModel model;
    ParticleState state;

    explicit HeldSheet(double scale, double noise = 0) : model(validation::modelOf(patch, validation::unequalWeave())) {
        std::mt19937 random(5);
        for (int p = 0; p < model.particleCount(); ++p) {
            const int column = p % (cells + 1);
            if (column == 0 || column == cells) model.pinned.push_back(p);
            state.positions.push_back({scale * patch.material[p].x, patch.material[p].y,
                                       noise * (static_cast<double>(random()) / std::mt19937::max() - 0.5)});
        }
        state.velocities.resize(state.positions.size());
    }
};

/// Rest by statics, with what it took.
struct Settled {
    std::optional<dynamics::StaticReport> report;
    std::string error;
    Metrics metrics;
};

Settled settled(const ClothModel& model, ParticleState& state, const Vec3& gravity) {
    const double start = threadSeconds();
    const auto rest = dynamics::solveStatic(model, state, gravity, {}, {});
    Settled out;
    out.metrics.seconds = threadSeconds() - start;
    if (!rest) {
        out.error = rest.error().text;
        return out;
    }
    out.report = *rest;
    out.metrics.residual = rest->newton.residual;
    if (!rest->newton.converged)
        out.error =
            fmt::format("The residual is {:.2g} after {} iterations.", rest->newton.residual, rest->newton.iterations);
    double strain = 0;
    for (const cloth::Spring& s : model.structural)
        strain = std::max(strain, geometry::distance(state.positions[s.a], state.positions[s.b]) / s.restLength - 1);
    out.metrics.strain = strain;
    return out;
}

Findings s10Squeezed(const Effort&) {
    Findings found;
    for (const double noise : {1e-9, 0.0}) {
        HeldSheet sheet(0.5, noise);
        const Settled rest = settled(sheet.model, sheet.state, {});
        double height = 0;
        for (const Vec3& x : sheet.state.positions) height = std::max(height, std::abs(x.z));
        const auto indefinite =
            rest.report ? std::ranges::count_if(rest.report->newton.log, &dynamics::MinimiserIteration::indefinite) : 0;
        found.rows.push_back(tested(
            "S10",
            fmt::format("sheet squeezed to a half, {}: statics, {} of {} iterations indefinite, {:.0f} mm out of plane",
                        noise > 0 ? "1e-9 m out of plane" : "in its plane", indefinite,
                        rest.report ? rest.report->newton.iterations : 0, 1e3 * height),
            rest.error.empty() && (noise == 0 || height > 0.01),
            rest.error.empty() ? "It should leave its plane." : rest.error, rest.metrics));
    }
    HeldSheet sheet(0.5, 1e-9);
    found.rows.push_back(judged("S10", "the same by TR-BDF2, half a second",
                                watched(sheet.model, sheet.state, {.steps = 30, .gravity = {}}), Method::trBdf2));
    return found;
}

Findings s11Gravity(const Effort& effort) {
    Findings found;
    for (const double times : {1e3, 1e6})
        for (const Method method : {Method::trBdf2, Method::backwardEuler, Method::xpbd}) {
            Scene scene = *sceneNamed("two-corners", {8, 100});
            const Watched run = watched(scene.model, scene.start,
                                        {.method = method,
                                         .steps = effort.quick ? 6 : 30,
                                         .gravity = times * downward,
                                         .timeLimit = effort.quick ? 10.0 : 60.0});
            found.rows.push_back(judged("S11", fmt::format("gravity × {:g}, {}", times, nameOf(method)), run, method));
        }
    Scene scene = *sceneNamed("two-corners", {8, 100});
    for (Vec3& x : scene.start.positions) x = 1.01 * x;
    const Settled rest = settled(scene.model, scene.start, {});
    found.rows.push_back(
        tested("S11", "no gravity, stretched by 1 %: statics", rest.error.empty(), rest.error, rest.metrics));
    return found;
}

Findings s13Pins(const Effort&) {
    Findings found;
    auto scene = validation::twoSquares();
    for (const char* id : {"one", "other"})
        scene.pattern.pins.push_back({pattern::PinId(id), pattern::PieceId("left"), pattern::VertexId("v0")});
    const auto problems = pattern::checkPattern(scene.pattern);
    const auto problem = std::ranges::find_if(problems, &pattern::Problem::isError);
    found.rows.push_back(mustBeRefused("S13", "two pins on one point", problem == problems.end() ? "" : problem->text));
    for (const Method method : {Method::trBdf2, Method::xpbd}) {
        HeldSheet sheet(3);
        found.rows.push_back(judged("S13",
                                    fmt::format("pins that pull a sheet to three times its width, {}", nameOf(method)),
                                    watched(sheet.model, sheet.state, {.method = method, .steps = 30}), method));
    }
    HeldSheet sheet(3);
    const Settled rest = settled(sheet.model, sheet.state, downward);
    found.rows.push_back(tested("S13", "the same by statics", rest.error.empty(), rest.error, rest.metrics));
    return found;
}

Findings s25NoStiffness(const Effort&) {
    Findings found;
    struct Without {
        const char* what;
        void (*take)(material::Fabric&);
    };
    for (const Without& without :
         {Without{"bending", [](material::Fabric& f) { f.warpBending = f.weftBending = f.biasBending = 0; }},
          {"shear", [](material::Fabric& f) { f.shearStiffness = 0; }},
          {"warp", [](material::Fabric& f) { f.warpStiffness = 0; }}}) {
        material::Fabric fabric = validation::unequalWeave();
        without.take(fabric);
        const cloth::Patch patch = cloth::gridPatch(cloth::evenLines(0.2, 8), cloth::evenLines(0.2, 8));
        ClothModel model;
        const auto done = cloth::appendPatch(model, patch, fabric);
        const std::string what = fmt::format("cloth without {} stiffness", without.what);
        if (!done) {
            found.rows.push_back(mustBeRefused("S25", what, done.error().text));
            continue;
        }
        model.pinned = {72, 80}; // two corners
        ParticleState start;     // level
        for (const Vec2& m : patch.material) start.positions.push_back({m.x, 0, m.y});
        ParticleState state = start;
        found.rows.push_back(judged("S25", what + ", TR-BDF2", watched(model, state, {.steps = 30}), Method::trBdf2));
        state = start;
        found.rows.push_back(
            judged("S25", what + ", XPBD", watched(model, state, {.method = Method::xpbd, .steps = 30}), Method::xpbd));
        state = start;
        const Settled rest = settled(model, state, downward);
        found.rows.push_back(tested("S25", what + ", statics", rest.error.empty(), rest.error, rest.metrics));
    }
    return found;
}

} // namespace

std::vector<Case> loadCases() {
    return {{"S10", "squeezed cloth", s10Squeezed},
            {"S11", "gravity", s11Gravity},
            {"S13", "contradictory pins", s13Pins},
            {"S25", "no stiffness", s25NoStiffness}};
}

} // namespace toile::study::stability
