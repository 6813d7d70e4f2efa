// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BodyContact.h"
#include "core/dynamics/Energy.h"
#include "core/dynamics/Method.h"
#include "core/geometry/Shapes.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Sheets.h"

#include <fmt/format.h>
#include <numbers>
#include <numeric>

namespace toile::study::validation {
using dynamics::Method;

namespace {

constexpr double g = standardGravity, mu = 0.3, degrees = std::numbers::pi / 180;
constexpr double target = 0.003 + 0.0002; // skin offset + half thickness [m]

/// A patch of cloth at its contact distance over a level plane; slopes are made by turning gravity.
struct Patch5 {
    collision::BodySurface plane;
    Patch patch = gridPatch(evenLines(0.05, 5), evenLines(0.05, 5));
    ClothModel model = modelOf(patch, unequalWeave());
    dynamics::ParticleState state;

    Patch5() : plane(*collision::BodySurface::create(geometry::plane(4, 16))) {
        for (const Vec2& m : patch.material) state.positions.push_back({m.x - 1, target, m.y});
        state.velocities.resize(state.positions.size());
    }
    [[nodiscard]] dynamics::BodyContact contact() const {
        const std::vector<double> half(state.positions.size(), 0.0002), friction(state.positions.size(), mu);
        return {plane, dynamics::particleSamples(model, half, friction, mu)};
    }
    [[nodiscard]] double speedAlong() const {
        return momentum(model, state).x /
               (model.mass.empty() ? 1 : std::accumulate(model.mass.begin(), model.mass.end(), 0.0));
    }
    [[nodiscard]] double placeAlong() const {
        double sum = 0;
        for (const Vec3& p : state.positions) sum += p.x;
        return sum / static_cast<double>(state.positions.size());
    }
};

Vec3 slope(double angle) {
    return {g * std::sin(angle), -g * std::cos(angle), 0};
}

void run(Findings& found, dynamics::Integrator& integrator, Patch5& world, dynamics::Stage& contact, double angle,
         double seconds) {
    dynamics::Stage* stages[] = {&contact};
    const int steps = static_cast<int>(std::lround(seconds * 60));
    for (int i = 0; i < steps; ++i)
        if (!found.ran(integrator.step(world.state, 1.0 / 60, slope(angle), stages))) return;
}

template <Method method>
void v9CoulombPatchOnASlope(Findings& found) {
    const std::string name(dynamics::nameOf(method));
    const double critical = std::atan(mu);
    const auto laidDown = [&](Patch5& world, dynamics::Stage& contact) { // on a slope that holds it
        const auto damped = dynamics::makeIntegrator(method, world.model, {.damping = 20});
        run(found, *damped, world, contact, 10 * degrees, 0.5);
    };
    const auto after = [&](double angle, double settle, double seconds) { // mean speed over the seconds
        Patch5 world;
        auto contact = world.contact();
        laidDown(world, contact);
        const auto integrator = dynamics::makeIntegrator(method, world.model, {.damping = 0});
        run(found, *integrator, world, contact, angle, settle);
        const double from = world.placeAlong();
        run(found, *integrator, world, contact, angle, seconds);
        return (world.placeAlong() - from) / seconds;
    };
    found.atMost(fmt::format("{}: creep 0.2° below the angle of friction [m/s]", name), 1e-4,
                 std::abs(after(critical - 0.2 * degrees, 0.5, 1)));
    double sticks = critical - 1 * degrees, slips = critical + 1 * degrees;
    while (slips - sticks > 0.05 * degrees) {
        const double middle = 0.5 * (sticks + slips);
        (after(middle, 0.5, 1) > 1e-3 ? slips : sticks) = middle;
    }
    found.within(fmt::format("{}: angle from which it goes on slipping [°]", name), critical / degrees, slips / degrees,
                 0.2 * degrees / critical);

    Patch5 world;
    auto contact = world.contact();
    laidDown(world, contact);
    const auto integrator = dynamics::makeIntegrator(method, world.model, {.damping = 0});
    run(found, *integrator, world, contact, 30 * degrees, 0.5);
    const double before = world.speedAlong();
    run(found, *integrator, world, contact, 30 * degrees, 0.5);
    found.within(fmt::format("{}: acceleration on 30° [m/s²]", name), 2.3563, (world.speedAlong() - before) / 0.5,
                 0.01);
}

template <Method method>
Case slopeBy() {
    return {"V9", "contact", "Coulomb patch on an incline", v9CoulombPatchOnASlope<method>};
}

} // namespace

std::vector<Case> contactCases() {
    return {slopeBy<Method::xpbd>(), slopeBy<Method::trBdf2>(), slopeBy<Method::backwardEuler>(),
            slopeBy<Method::bdf2>(), slopeBy<Method::sdirk4>(), slopeBy<Method::symplecticEuler>(),
            slopeBy<Method::rk4>()};
}

} // namespace toile::study::validation
