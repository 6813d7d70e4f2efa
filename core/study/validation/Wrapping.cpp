// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/BodyContact.h"
#include "core/dynamics/Method.h"
#include "core/dynamics/Statics.h"
#include "core/geometry/Shapes.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Sheets.h"
#include "core/study/validation/Tube.h"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

/// Cloth round a cylinder.
namespace toile::study::validation {
namespace {

using dynamics::Method;

constexpr double pi = std::numbers::pi;
constexpr double target = 0.003 + 0.0002; // skin offset + half thickness [m]

dynamics::BodyContact contactWith(const collision::BodySurface& body, const ClothModel& model, double friction,
                                  const dynamics::BodyContactSettings& settings = {}) {
    const std::vector<double> half(model.mass.size(), 0.0002), cloth(model.mass.size(), friction);
    return {body, dynamics::particleSamples(model, half, cloth, friction), settings};
}

/// A tube that is a tenth too narrow for its cylinder, without weight or friction.
struct Sleeve {
    static constexpr double stretch = 0.1;
    Tube tube;
    collision::BodySurface body;
    dynamics::BodyContact contact;

    Sleeve(Tube of, double bodyRadius, const dynamics::BodyContactSettings& settings)
        : tube(std::move(of)), body(*collision::BodySurface::create(geometry::cylinder(bodyRadius, 0.1, 256, 16))),
          contact(contactWith(body, tube.garment.model, 0, settings)) {}

    /// Pull across a line along the tube [N per m of its height]: what lies on all particles, inwards, is 2π times it.
    [[nodiscard]] double tension() const {
        std::vector<Vec3> forces(tube.state.positions.size());
        cloth::addForces(tube.garment.model, tube.state.positions, forces);
        double inward = 0;
        for (std::size_t p = 0; p < forces.size(); ++p) {
            const Vec3& x = tube.state.positions[p];
            inward -= (forces[p].x * x.x + forces[p].z * x.z) / std::hypot(x.x, x.z);
        }
        return inward / (2 * pi * tube.height);
    }
    [[nodiscard]] double radius() const {
        double sum = 0;
        for (const Vec3& x : tube.state.positions) sum += std::hypot(x.x, x.z);
        return sum / static_cast<double>(tube.state.positions.size());
    }
};

constexpr double clothRadius = 0.1, stiffness = 200; // stretched [m], uniaxial [N/m]

std::unique_ptr<Sleeve> sleeveOf(Findings& found, const dynamics::BodyContactSettings& settings = {}) {
    Fabric fabric = unequalWeave();
    fabric.weftStiffness = stiffness;
    const double round = 2 * pi * clothRadius / (1 + Sleeve::stretch);
    auto tube = tubeOf(found, fabric, round, 0.05, round / 96);
    if (!tube) return nullptr;
    for (Vec3& x : tube->state.positions) // round the cylinder, in its middle
        x = {x.x * (1 + Sleeve::stretch), x.y - 0.025, x.z * (1 + Sleeve::stretch)};
    return std::make_unique<Sleeve>(std::move(*tube), clothRadius - target, settings);
}

void compare(Findings& found, const std::string& how, const Sleeve& sleeve) {
    const double tension = stiffness * Sleeve::stretch;
    found.within(fmt::format("tube a tenth too narrow, {}: hoop tension [N/m]", how), tension, sleeve.tension(), 0.01);
    found.within("the same: fit pressure [Pa]", tension / clothRadius, sleeve.tension() / sleeve.radius(), 0.01);
}

/// With so many substeps that no spring is capped: a cap changes what the cloth is.
void v24FitPressureWhileMoving(Findings& found) {
    const auto sleeve = sleeveOf(found);
    if (!sleeve) return;
    dynamics::Stage* stages[] = {&sleeve->contact};
    const auto xpbd =
        dynamics::makeIntegrator(Method::xpbd, sleeve->tube.garment.model, {.damping = 20, .substeps = 160});
    for (int frame = 0; frame < 90 && !found.stopped(); ++frame)
        found.ran(xpbd->step(sleeve->tube.state, 1.0 / 60, {}, stages));
    compare(found, "XPBD, 160 substeps", *sleeve);
}

void settle(Findings& found, const std::string& how, const dynamics::BodyContactSettings& settings) {
    const auto sleeve = sleeveOf(found, settings);
    if (!sleeve) return;
    dynamics::Stage* stages[] = {&sleeve->contact};
    const auto rest = dynamics::solveStatic(sleeve->tube.garment.model, sleeve->tube.state, {}, stages);
    if (!found.ran(rest)) return;
    if (!rest->newton.converged) return found.stop("Statics found no equilibrium.");
    compare(found, how, *sleeve);
}

void v24FitPressureAtRest(Findings& found) {
    settle(found, "statics", {});
}

void v24FitPressureOnAHardBody(Findings& found) {
    settle(found, "statics with contact 20 times as stiff",
           {.stiffness = 20 * dynamics::BodyContactSettings{}.stiffness});
}

/// A light strip over a cylinder, half round it, with a weight at either end.
struct Belt {
    static constexpr double friction = 0.3, radius = 0.05, light = 0.002, heavy = 0.008; // [–], [m], [kg], [kg]
    static constexpr double tails[2] = {0.15, 0.06};                                     // light and heavy end [m]
    collision::BodySurface body;
    ClothModel model;
    ParticleState state;
    int columns = 0;

    Belt() : body(*collision::BodySurface::create(geometry::cylinder(radius - target, 0.1, 256, 16))) {
        Fabric fabric = unequalWeave();
        fabric.arealDensity = 0.02;
        fabric.warpStiffness = fabric.weftStiffness = 200;
        fabric.warpBending = fabric.weftBending = fabric.biasBending = 0;
        const double over = pi * radius, all = tails[0] + over + tails[1];
        columns = static_cast<int>(std::lround(all / 0.005)) + 1;
        const Patch patch = gridPatch(evenLines(all, columns - 1), evenLines(0.02, 2));
        model = modelOf(patch, fabric);
        for (const Vec2& m : patch.material) state.positions.push_back(at(m.x, m.y - 0.01));
        state.velocities.resize(state.positions.size());
        for (int row = 0; row < 3; ++row) {
            model.mass[row * columns] += light / 3;
            model.mass[row * columns + columns - 1] += heavy / 3;
        }
    }
    [[nodiscard]] static Vec3 at(double along, double across) { // the tails hang towards −x
        const double over = pi * radius, s = along - tails[0];
        if (s < 0) return {s, across, radius};
        if (s > over) return {over - s, across, -radius};
        return {radius * std::sin(s / radius), across, radius * std::cos(s / radius)};
    }
    /// How the cylinder feels the two tails pull [N]: what the rest of the strip exerts on them.
    struct Pulls {
        double light = 0, heavy = 0;
    };
    [[nodiscard]] Pulls pulls() const {
        std::vector<Vec3> forces(state.positions.size());
        cloth::addForces(model, state.positions, forces);
        Pulls sum;
        for (std::size_t p = 0; p < forces.size(); ++p)
            if (state.positions[p].x < 0) (state.positions[p].z > 0 ? sum.light : sum.heavy) += forces[p].x;
        return sum;
    }
};

template <Method method>
void v25Capstan(Findings& found) {
    Belt belt;
    auto contact = contactWith(belt.body, belt.model, Belt::friction);
    dynamics::Stage* stages[] = {&contact};
    const Vec3 gravity{-standardGravity, 0, 0};
    const auto integrator = dynamics::makeIntegrator(method, belt.model, {.damping = 5, .substeps = 200});
    Belt::Pulls sum; // over the second half, when it slips evenly
    for (int frame = 0; frame < 96 && !found.stopped(); ++frame) {
        found.ran(integrator->step(belt.state, 1.0 / 240, gravity, stages));
        if (frame < 48) continue;
        const Belt::Pulls now = belt.pulls();
        sum.light += now.light;
        sum.heavy += now.heavy;
    }
    found.within(fmt::format("strip slipping over half a cylinder, μ = 0.3, {}", dynamics::nameOf(method)),
                 std::exp(Belt::friction * pi), sum.heavy / sum.light, 0.03);
}

} // namespace

std::vector<Case> wrappingCases() {
    constexpr std::string_view theme = "wrapping";
    return {
        {"V24", theme, "cylinder hoop: fit pressure while moving", v24FitPressureWhileMoving},
        {"V24", theme, "cylinder hoop: fit pressure at rest", v24FitPressureAtRest},
        {"V24", theme, "cylinder hoop: fit pressure on a hard body", v24FitPressureOnAHardBody},
        {"V25", theme, "capstan", v25Capstan<Method::xpbd>},
        {"V25", theme, "capstan", v25Capstan<Method::trBdf2>},
    };
}

} // namespace toile::study::validation
