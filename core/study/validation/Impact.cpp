// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/collision/Intersections.h"
#include "core/dynamics/BodyContact.h"
#include "core/dynamics/Energy.h"
#include "core/dynamics/Method.h"
#include "core/geometry/Shapes.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Layers.h"
#include "core/study/validation/Sheets.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

/// Cloth that meets a body or itself.
namespace toile::study::validation {
namespace {

using dynamics::Method;

/// A square of 0.1 m, level, thrown down at a slab 0.1 m thick.
template <Method method>
void v26DropOnAPlane(Findings& found) {
    const auto slab = collision::BodySurface::create(geometry::box({-1, -0.1, -1}, {1, 0, 1}));
    if (!found.ran(slab)) return;
    const Patch patch = gridPatch(evenLines(0.1, 8), evenLines(0.1, 8));
    const ClothModel model = modelOf(patch, unequalWeave());
    const std::vector<double> half(model.mass.size(), 0.0002), friction(model.mass.size(), 0.3);
    for (const double speed : {1.0, 10.0, 100.0}) {
        dynamics::BodyContact contact(*slab, dynamics::particleSamples(model, half, friction, 0.3));
        dynamics::Stage* stages[] = {&contact};
        ParticleState state;
        for (const Vec2& m : patch.material) state.positions.push_back({m.x - 0.05, 0.02, m.y - 0.05});
        state.velocities.assign(state.positions.size(), {0, -speed, 0});
        const auto integrator = dynamics::makeIntegrator(method, model, {.damping = 0, .substeps = 20});
        const double start = dynamics::energies(model, state, downward).total();
        double lowest = 1, most = start;
        for (int frame = 0; frame < 60 && !found.stopped(); ++frame) {
            found.ran(integrator->step(state, 1.0 / 60, downward, stages));
            for (const Vec3& x : state.positions) lowest = std::min(lowest, x.y);
            most = std::max(most, dynamics::energies(model, state, downward).total());
        }
        const auto name = dynamics::nameOf(method);
        found.atMost(fmt::format("drop at {:g} m/s, {}: depth below the plane [m]", speed, name), 0, -lowest);
        found.atMost(fmt::format("the same: energy above its start, relative", speed, name), 0, most / start - 1);
    }
}

/// A strip of 0.2 m that is bent back over itself, the lower half held, and let fall.
void v27FoldedStrip(Findings& found) {
    constexpr double half = 0.1, gap = 0.01, bend = gap / 2 * std::numbers::pi;
    constexpr int cells = 48;
    LayeredCloth strip;
    const double all = 2 * half + bend;
    append(strip, all, cells, 0.03, 6, 0.3, [&](const Vec2& m) {
        if (m.x < half) return Vec3{m.x, 0, m.y};
        if (m.x > half + bend) return Vec3{2 * half + bend - m.x, gap, m.y};
        const double turn = (m.x - half) / (gap / 2);
        return Vec3{half + gap / 2 * std::sin(turn), gap / 2 * (1 - std::cos(turn)), m.y};
    });
    std::vector<std::array<int, 3>> upper, lower;
    for (const auto& t : strip.surface.triangles) {
        const auto isIn = [&](auto&& test) { return std::ranges::all_of(t, test); };
        if (isIn([&](int p) { return p % (cells + 1) * all / cells < 0.9 * half; })) lower.push_back(t);
        if (isIn([&](int p) { return p % (cells + 1) * all / cells > all - 0.9 * half; })) upper.push_back(t);
    }
    for (int p = 0; p < strip.model.particleCount(); ++p)
        if (strip.state.positions[p].y == 0 && strip.state.positions[p].x < 0.9 * half) strip.model.pinned.push_back(p);
    dynamics::SelfContact contact(strip.model, strip.surface);
    dynamics::Stage* stages[] = {&contact};
    const auto integrator = dynamics::makeIntegrator(Method::xpbd, strip.model, {.damping = 2, .substeps = 40});
    int intersections = strip.intersections();
    double least = std::numeric_limits<double>::infinity();
    for (int frame = 0; frame < 90 && !found.stopped(); ++frame) {
        found.ran(integrator->step(strip.state, 1.0 / 60, downward, stages));
        intersections += strip.intersections();
        if (frame % 10 == 9) least = std::min(least, leastDistance(strip.state.positions, upper, lower));
    }
    found.atMost("folded strip, 1.5 s: intersections over all frames", 0, intersections);
    found.atMost("the same: thickness less the least distance [m]", 1e-9, layerThickness - least); // rounding
}

} // namespace

std::vector<Case> impactCases() {
    constexpr std::string_view theme = "impact";
    return {
        {"V26", theme, "drop on a plane", v26DropOnAPlane<Method::xpbd>},
        {"V26", theme, "drop on a plane", v26DropOnAPlane<Method::backwardEuler>},
        {"V26", theme, "drop on a plane", v26DropOnAPlane<Method::trBdf2>},
        {"V27", theme, "folded strip on itself", v27FoldedStrip},
    };
}

} // namespace toile::study::validation
