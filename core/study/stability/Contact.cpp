// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/Intersections.h"
#include "core/dynamics/BodyContact.h"
#include "core/geometry/Shapes.h"
#include "core/study/stability/Cases.h"
#include "core/study/validation/Layers.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <fmt/format.h>

/// Cloth that meets a body or itself too fast, too deep, or too often.
namespace toile::study::stability {
namespace {

using cloth::ClothModel;
using dynamics::Method;
using dynamics::ParticleState;
using validation::append;
using validation::LayeredCloth;
using validation::layerThickness;

dynamics::BodyContact contactWith(const collision::BodySurface& body, const ClothModel& model) {
    const std::vector<double> half(model.mass.size(), layerThickness / 2), friction(model.mass.size(), 0.3);
    return {body, dynamics::particleSamples(model, half, friction, 0.3)};
}

collision::BodySurface ball() {
    return *collision::BodySurface::create(geometry::starBody(48, 96, [](const Vec3&) { return 0.1; }));
}

/// A level sheet of 0.2 m in the middle of the axes, moved up.
struct Sheet {
    cloth::Patch patch = cloth::gridPatch(cloth::evenLines(0.2, 16), cloth::evenLines(0.2, 16));
    ClothModel model = validation::modelOf(patch, validation::unequalWeave());
    ParticleState state;

    explicit Sheet(double height, const Vec3& velocity = {}) {
        for (const Vec2& m : patch.material) state.positions.push_back({m.x - 0.1, height, m.y - 0.1});
        state.velocities.assign(state.positions.size(), velocity);
    }
    static constexpr int middle = 8 * 17 + 8;
};

/// What is kept apart, and what crossed, over a run.
struct Apart {
    double distance = 1; ///< least clearance to the body [m]
    int intersections = 0;
};

Row judgedApart(const std::string& number, const std::string& what, Watched run, Method method, const Apart& apart,
                bool withDistance) {
    if (withDistance) run.metrics.distance = apart.distance;
    Row row = judged(number, what, run, method);
    const bool passes = row.verdict != Verdict::fail;
    if (passes && withDistance && apart.distance < 0)
        return tested(number, what, false, "Cloth came into the body.", row.metrics);
    if (passes && apart.intersections > 0)
        return tested(number, what, false, fmt::format("{} intersections.", apart.intersections), row.metrics);
    return row;
}

double lowest(const ParticleState& state) {
    double low = 1;
    for (const Vec3& x : state.positions) low = std::min(low, x.y);
    return low;
}

Findings s12Fast(const Effort&) {
    Findings found;
    const auto slab = *collision::BodySurface::create(geometry::box({-1, -0.1, -1}, {1, 0, 1}));
    for (const Method method : {Method::xpbd, Method::backwardEuler, Method::trBdf2}) {
        Sheet sheet(0.02, {0, -100, 0});
        auto contact = contactWith(slab, sheet.model);
        dynamics::Stage* stages[] = {&contact};
        Apart apart;
        const Watched run = watched(
            sheet.model, sheet.state,
            {.method = method,
             .integrator = {.substeps = 20},
             .steps = 30,
             .afterStep = [&](const ParticleState& s) { apart.distance = std::min(apart.distance, lowest(s)); }},
            stages);
        found.rows.push_back(judgedApart("S12", fmt::format("sheet at 100 m/s on a body, {}", nameOf(method)), run,
                                         method, apart, true));
    }
    LayeredCloth layers;
    append(layers, 0.2, 10, 0.2, 10, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.1, 0, 0.1 - m.y}; });
    for (int p = 0; p < layers.model.particleCount(); ++p) layers.model.pinned.push_back(p);
    append(layers, 0.1, 10, 0.1, 10, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.05, 0.02, 0.05 - m.y}; });
    for (std::size_t p = layers.model.pinned.size(); p < layers.state.velocities.size(); ++p)
        layers.state.velocities[p] = {0, -100, 0};
    dynamics::SelfContact contact(layers.model, layers.surface);
    dynamics::Stage* stages[] = {&contact};
    Apart apart;
    const Watched run =
        watched(layers.model, layers.state,
                {.method = Method::xpbd,
                 .integrator = {.substeps = 20},
                 .steps = 30,
                 .afterStep = [&](const ParticleState&) { apart.intersections += layers.intersections(); }},
                stages);
    found.rows.push_back(judgedApart("S12", "sheet at 100 m/s on a held sheet, xpbd", run, Method::xpbd, apart, false));
    return found;
}

Findings s14PinInTheBody(const Effort&) {
    Findings found;
    const auto body = ball();
    Sheet sheet(0.11);
    sheet.model.pinned = {Sheet::middle};
    sheet.state.positions[Sheet::middle] = {0, 0.05, 0};
    auto contact = contactWith(body, sheet.model);
    dynamics::Stage* stages[] = {&contact};
    Watched run = watched(sheet.model, sheet.state, {.method = Method::xpbd, .steps = 60}, stages);
    run.metrics.distance = contact.clearance(sheet.state.positions);
    Row row = judged("S14", "a pin 50 mm inside the body: contact reports its depth, xpbd", run, Method::xpbd);
    if (row.verdict == Verdict::pass && std::abs(*run.metrics.distance + 0.05) > 0.001)
        row = tested(row.number, row.what, false, "The depth of the pin is 50 mm.", row.metrics);
    found.rows.push_back(std::move(row));

    Sheet driven(0.11);
    driven.model.pinned = {Sheet::middle};
    auto through = contactWith(body, driven.model);
    stages[0] = &through;
    Watched push = watched(driven.model, driven.state,
                           {.method = Method::xpbd,
                            .steps = 60,
                            .afterStep = [](ParticleState& s) { s.positions[Sheet::middle].y -= 0.22 / 60; }},
                           stages);
    push.metrics.energyGrowth.reset(); // the hand that drives it does work
    push.metrics.distance = through.clearance(driven.state.positions);
    row = judged("S14", "a pin driven through the body in a second, xpbd", push, Method::xpbd);
    if (row.verdict == Verdict::pass && *push.metrics.speed > 10)
        row = tested(row.number, row.what, false, "It threw the cloth.", row.metrics);
    found.rows.push_back(std::move(row));
    return found;
}

/// Twice the speed at which contact may push out [m/s].
constexpr double thrown = 1;

Findings s22Overlapping(const Effort&) {
    Findings found;
    const auto body = ball();
    Sheet inside(0.08); // its middle is 20 mm deep
    auto contact = contactWith(body, inside.model);
    dynamics::Stage* stages[] = {&contact};
    Watched run = watched(inside.model, inside.state,
                          {.method = Method::xpbd, .integrator = {.damping = 2}, .steps = 60, .gravity = {}}, stages);
    run.metrics.energyGrowth.reset(); // pushing out does work
    run.metrics.distance = contact.clearance(inside.state.positions);
    Row row = judged("S22", "a sheet that starts 20 mm inside the body, xpbd", run, Method::xpbd);
    if (row.verdict == Verdict::pass && *run.metrics.distance < 0.001)
        row = tested(row.number, row.what, false, "It does not come out.", row.metrics);
    if (row.verdict == Verdict::pass && *run.metrics.speed > thrown)
        row = tested(row.number, row.what, false, "It is thrown out.", row.metrics);
    found.rows.push_back(std::move(row));

    // A hanging sheet, the lower part of which has gone through a held one.
    LayeredCloth layers;
    append(layers, 0.2, 10, 0.2, 10, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.1, 0, 0.1 - m.y}; });
    for (int p = 0; p < layers.model.particleCount(); ++p) layers.model.pinned.push_back(p);
    append(layers, 0.1, 10, 0.1, 10, 0.3, [](const Vec2& m) { return Vec3{m.x - 0.05, m.y - 0.015, 0.003}; });
    const int before = layers.intersections();
    dynamics::SelfContact self(layers.model, layers.surface);
    stages[0] = &self;
    Watched uncrossed =
        watched(layers.model, layers.state,
                {.method = Method::xpbd, .integrator = {.damping = 2}, .steps = 120, .gravity = {}}, stages);
    uncrossed.metrics.energyGrowth.reset();
    const int after = layers.intersections();
    row =
        judged("S22", fmt::format("a sheet 15 mm through another: {} intersections, {} after 2 s, xpbd", before, after),
               uncrossed, Method::xpbd);
    if (row.verdict == Verdict::pass && *uncrossed.metrics.speed > thrown)
        row = tested(row.number, row.what, false, "It is thrown out.", row.metrics);
    else if (row.verdict == Verdict::pass && after > 0) {
        row.verdict = self.guaranteed() ? Verdict::fail : Verdict::passWithWarning;
        row.why =
            self.guaranteed() ? "They still cross, and the guarantee is given." : "They still cross: no guarantee.";
    }
    found.rows.push_back(std::move(row));
    return found;
}

/// Squares of 5 cm above each other, the lowest held, the uppermost as heavy as is asked.
Findings s28Pressed(const Effort& effort) {
    const int layers = effort.quick ? 16 : 64;
    LayeredCloth pile;
    int top = 0;
    for (int layer = 0; layer < layers; ++layer) {
        top = append(pile, 0.05, 4, 0.05, 4, 0.3, [&](const Vec2& m) {
            return Vec3{m.x, 1.2 * layerThickness * layer, m.y};
        });
        if (layer == 0)
            for (int p = 0; p < pile.model.particleCount(); ++p) pile.model.pinned.push_back(p);
    }
    for (int p = top; p < pile.model.particleCount(); ++p) pile.model.mass[p] *= 100;
    dynamics::SelfContact contact(pile.model, pile.surface);
    dynamics::Stage* stages[] = {&contact};
    Apart apart;
    const Watched run =
        watched(pile.model, pile.state,
                {.method = Method::xpbd,
                 .integrator = {.damping = 2, .substeps = 20},
                 .steps = effort.quick ? 30 : 60,
                 .timeLimit = 120,
                 .afterStep = [&](const ParticleState&) { apart.intersections += pile.intersections(); }},
                stages);
    const int perLayer = static_cast<int>(pile.surface.triangles.size()) / layers;
    const std::span triangles(pile.surface.triangles);
    for (int layer = 1; layer < layers; ++layer)
        apart.distance =
            std::min(apart.distance, validation::leastDistance(pile.state.positions,
                                                               triangles.subspan((layer - 1) * perLayer, perLayer),
                                                               triangles.subspan(layer * perLayer, perLayer)));
    return {{judgedApart("S28", fmt::format("{} layers pressed by a hundred more, xpbd", layers), run, Method::xpbd,
                         apart, true)},
            {}};
}

} // namespace

std::vector<Case> contactCases() {
    return {{"S12", "fast", s12Fast},
            {"S14", "a pin inside the body", s14PinInTheBody},
            {"S22", "overlapping at the start", s22Overlapping},
            {"S28", "many layers", s28Pressed}};
}

} // namespace toile::study::stability
