// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"

#include "core/base/Contracts.h"
#include "core/cloth/FoldAngle.h"
#include "core/cloth/MembraneCellForces.h"
#include "core/cloth/TriangleForces.h"

#include <cmath>

namespace toile::cloth {
namespace {

using Positions = std::span<const Vec3>;

double energyOf(const std::vector<Spring>& springs, Positions x) {
    double sum = 0;
    for (const Spring& s : springs) {
        const double stretch = distance(x[s.a], x[s.b]) - s.restLength;
        sum += 0.5 * s.stiffness * stretch * stretch;
    }
    return sum;
}

Vec3 valueOf(const Stencil& stencil, Positions x) {
    Vec3 sum;
    for (int i = 0; i < 4 && stencil.particles[i] >= 0; ++i) sum += stencil.coefficients[i] * x[stencil.particles[i]];
    return sum;
}

double energyOf(const std::vector<Stencil>& stencils, Positions x) {
    double sum = 0;
    for (const Stencil& s : stencils) sum += 0.5 * s.stiffness * squaredLength(valueOf(s, x));
    return sum;
}

double energyOf(const std::vector<Hinge>& hinges, Positions x) {
    double sum = 0;
    for (const Hinge& h : hinges) {
        const double angle = angleFrom(h.restAngle, foldAngle(x[h.a], x[h.b], x[h.c], x[h.d]).angle);
        sum += 0.5 * h.stiffness * angle * angle;
    }
    return sum;
}

DeformationGradient gradientOf(const MembraneTriangle& t, Positions x) {
    return deformationGradient(t, x[t.particles[0]], x[t.particles[1]], x[t.particles[2]]);
}

CellSides sidesOf(const MembraneCell& c, Positions x) {
    return cellSides(c, {x[c.particles[0]], x[c.particles[1]], x[c.particles[2]], x[c.particles[3]]});
}

void addForcesOf(const std::vector<Spring>& springs, Positions x, std::span<Vec3> forces) {
    for (const Spring& s : springs) {
        const Vec3 d = x[s.b] - x[s.a];
        const double length = geometry::length(d);
        const Vec3 force = length > 0 ? (s.stiffness * (length - s.restLength) / length) * d
                                      : -s.stiffness * s.restLength * ownDirection(s.a, s.b);
        forces[s.a] += force;
        forces[s.b] -= force;
    }
}

void addForcesOf(const std::vector<Stencil>& stencils, Positions x, std::span<Vec3> forces) {
    for (const Stencil& s : stencils) {
        const Vec3 pull = -s.stiffness * valueOf(s, x);
        for (int i = 0; i < 4 && s.particles[i] >= 0; ++i) forces[s.particles[i]] += s.coefficients[i] * pull;
    }
}

void addForcesOf(const std::vector<Hinge>& hinges, Positions x, std::span<Vec3> forces) {
    for (const Hinge& h : hinges) {
        const FoldAngle fold = foldAngle(x[h.a], x[h.b], x[h.c], x[h.d]);
        const double moment = -h.stiffness * angleFrom(h.restAngle, fold.angle);
        const int particles[4] = {h.a, h.b, h.c, h.d};
        for (int i = 0; i < 4; ++i) forces[particles[i]] += moment * fold.gradient[i];
    }
}

} // namespace

Vec3 ownDirection(int a, int b) {
    constexpr double goldenAngle = 2.399963229728653; // [rad]
    const double turn = goldenAngle * (a + 1), height = std::sin(goldenAngle * (b + 1));
    const double across = std::sqrt(1 - height * height);
    return {across * std::cos(turn), height, across * std::sin(turn)};
}

ElasticEnergy elasticEnergy(const ClothModel& model, Positions x) {
    ElasticEnergy e;
    e.springs = energyOf(model.structural, x) + energyOf(model.shear, x) + energyOf(model.elastics, x) +
                energyOf(model.flexion, x);
    e.bending = energyOf(model.bending, x) + energyOf(model.twist, x) + energyOf(model.hinges, x);
    for (const MembraneTriangle& t : model.triangles) e.membrane += triangleEnergy(model, t, gradientOf(t, x));
    for (const MembraneCell& c : model.cells) e.membrane += cellEnergy(model, c, sidesOf(c, x));
    return e;
}

double energy(const ClothModel& model, Positions x) {
    return elasticEnergy(model, x).total();
}

void addForces(const ClothModel& model, Positions x, std::span<Vec3> forces) {
    expects(x.size() == model.mass.size() && forces.size() == x.size(), "one position and force per particle");
    for (const auto* springs : {&model.structural, &model.shear, &model.elastics, &model.flexion})
        addForcesOf(*springs, x, forces);
    for (const auto* stencils : {&model.bending, &model.twist}) addForcesOf(*stencils, x, forces);
    addForcesOf(model.hinges, x, forces);
    for (const MembraneTriangle& t : model.triangles) {
        const DeformationGradient g = triangleGradient(model, t, gradientOf(t, x));
        const CornerWeights w = cornerWeights(t);
        for (int i = 0; i < 3; ++i) forces[t.particles[i]] -= w.u[i] * g.u + w.v[i] * g.v;
    }
    for (const MembraneCell& c : model.cells) {
        const CellSides g = cellGradient(model, c, sidesOf(c, x));
        const auto w = sideWeights(c);
        for (int s = 0; s < 4; ++s)
            for (int i = 0; i < 4; ++i) forces[c.particles[i]] -= w[s][i] * g[s];
    }
}

void gatherToMasters(const ClothModel& model, std::span<Vec3> forces) {
    for (const Slave& slave : model.slaves) {
        for (const auto& [master, weight] : slave.masters) forces[master] += weight * forces[slave.particle];
        forces[slave.particle] = {};
    }
}

void placeSlaves(const ClothModel& model, std::span<Vec3> positions) {
    for (const Slave& slave : model.slaves) {
        Vec3 place;
        for (const auto& [master, weight] : slave.masters) place += weight * positions[master];
        positions[slave.particle] = place;
    }
}

} // namespace toile::cloth
