// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/TrustedStep.h"

#include "core/dynamics/BlockVectors.h"

#include <algorithm>
#include <cmath>

namespace toile::dynamics {
namespace {

/// to += factor · by
void add(std::span<Vec3> to, double factor, std::span<const Vec3> by) {
    for (std::size_t i = 0; i < to.size(); ++i) to[i] += factor * by[i];
}

} // namespace

TrustedStep trustedStep(const BlockMatrix& hessian, RoundedFactor& preconditioner, std::span<const Vec3> forces,
                        double radius, const TrustedStepSettings& settings, Team* team) {
    TrustedStep step{.move = std::vector<Vec3>(forces.size())};
    const std::vector<double> unshifted(forces.size(), 0.0);
    const double tolerance = std::max(settings.forcing * largestOf(forces), settings.leastForce);
    std::vector<Vec3> r(forces.begin(), forces.end()), hp(forces.size());
    std::vector<Vec3> z = preconditioner.solve(r, team), p = z;
    double rz = dotOf(r, z);
    double ss = 0, sp = 0, pp = rz; // products by P of the step and the direction, without ever multiplying by it
    if (radius == 0) radius = std::sqrt(rz);
    while (step.iterations < settings.maximumIterations && rz > 0 && !settings.stop.stop_requested()) {
        ++step.iterations;
        hessian.multiply(unshifted, p, hp, team);
        const double curvature = dotOf(p, hp), along = rz / curvature;
        const double next = ss + 2 * along * sp + along * along * pp;
        if (!(curvature > 0) || next >= radius * radius) {
            const double left = radius * radius - ss, toBound = (std::sqrt(sp * sp + pp * left) - sp) / pp;
            add(step.move, toBound, p);
            step.expected += toBound * rz - 0.5 * toBound * toBound * curvature;
            step.bounded = true;
            step.downwards = !(curvature > 0);
            ss = radius * radius;
            break;
        }
        add(step.move, along, p);
        add(r, -along, hp);
        step.expected += 0.5 * along * rz;
        ss = next;
        if (largestOf(r) <= tolerance) break;
        z = preconditioner.solve(r, team);
        const double before = rz;
        rz = dotOf(r, z);
        const double turn = rz / before;
        sp = turn * (sp + along * pp);
        pp = rz + turn * turn * pp;
        for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + turn * p[i];
    }
    step.norm = std::sqrt(ss);
    return step;
}

} // namespace toile::dynamics
