// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/BodyContact.h"
#include "tests/collision/Shapes.h"
#include "tests/collision/Surfaces.h"

#include <functional>

/// Particles beside a body, for the tests of contact.
namespace toile::contactWorld {

using collision::BodySurface;
using dynamics::BodyContact;
using dynamics::ContactSample;
using shapes::surfaceOf;

constexpr double freeFall = 9.81;         // [m/s²]
constexpr double target = 0.003 + 0.0002; // skin offset + half thickness
constexpr double h = 1.0 / 1200;

inline ContactSample sampleAt(int particle, double friction, double mass = 2e-5) {
    return {{{particle, 1.0}}, 0.0002, friction, mass};
}

/// Particles of 20 mg under gravity with a contact stage and whatever else pulls, in substeps as the solver makes them.
struct World {
    std::vector<Vec3> positions, velocities;
    std::vector<double> inverseMass;
    Vec3 acceleration{0, -freeFall, 0};
    std::function<void(std::span<Vec3>, double)> cloth = [](std::span<Vec3>, double) {};

    explicit World(std::vector<Vec3> at)
        : positions(std::move(at)), velocities(positions.size()), inverseMass(positions.size(), 1 / 2e-5) {}

    void run(BodyContact& contact, double seconds, double step = h) {
        contact.beginStep({positions, velocities, 0}, seconds);
        for (double t = 0; t < seconds - step / 2; t += step) substep(contact, step);
    }
    void substep(BodyContact& contact, double step) {
        const std::vector<Vec3> previous = positions;
        for (std::size_t i = 0; i < positions.size(); ++i)
            if (inverseMass[i] > 0) positions[i] += (velocities[i] + acceleration * step) * step;
        cloth(positions, step);
        dynamics::Substep view{positions, previous, inverseMass, step, 0};
        contact.project(view);
        for (std::size_t i = 0; i < positions.size(); ++i) velocities[i] = (positions[i] - previous[i]) / step;
    }
};

/// Gravity as felt on a slope that falls towards +x, with the plane kept level.
inline Vec3 slope(double angle) {
    return {freeFall * std::sin(angle), -freeFall * std::cos(angle), 0};
}

constexpr double degrees = std::numbers::pi / 180;

} // namespace toile::contactWorld
