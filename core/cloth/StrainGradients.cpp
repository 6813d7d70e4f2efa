// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/StrainGradients.h"

#include "core/cloth/FoldAngle.h"
#include "core/cloth/Forces.h"
#include "core/cloth/MembraneCellForces.h"
#include "core/cloth/TriangleStrain.h"

namespace toile::cloth {
namespace {

void append(const Spring& s, std::span<const Vec3> x, std::vector<StrainGradient>& into) {
    const Vec3 d = x[s.b] - x[s.a];
    const double length = geometry::length(d);
    const Vec3 along = length > 0 ? d / length : ownDirection(s.a, s.b);
    into.push_back({{s.a, s.b, -1, -1}, {-along, along}, s.stiffness});
}

void append(const Stencil& s, std::vector<StrainGradient>& into) {
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
        StrainGradient strain{s.particles, {}, s.stiffness};
        for (int i = 0; i < 4; ++i) strain.gradient[i] = s.coefficients[i] * axis;
        into.push_back(strain);
    }
}

void append(const Hinge& h, std::span<const Vec3> x, std::vector<StrainGradient>& into) {
    into.push_back({{h.a, h.b, h.c, h.d}, foldAngle(x[h.a], x[h.b], x[h.c], x[h.d]).gradient, h.stiffness});
}

void append(const MembraneTriangle& t, std::span<const Vec3> x, std::vector<StrainGradient>& into) {
    const auto [a, b, c] = t.particles;
    const DeformationGradient f = deformationGradient(t, x[a], x[b], x[c]);
    const CornerWeights weights = cornerWeights(t);
    const Stretch stretch(f);
    const std::pair<Symmetric2, double> strains[] = {
        {{1, 0, 0}, t.stiffness.c11}, {{0, 1, 0}, t.stiffness.c22}, {{0, 0, 1}, t.stiffness.c33}};
    for (const auto& [of, modulus] : strains) {
        if (modulus <= 0) continue;
        const Symmetric2 z = stretch.solve(of);
        const Vec3 u = 2 * (f.u * z.xx + f.v * z.xy), v = 2 * (f.u * z.xy + f.v * z.yy);
        StrainGradient strain{{a, b, c, -1}, {}, t.area * modulus};
        for (int i = 0; i < 3; ++i) strain.gradient[i] = weights.u[i] * u + weights.v[i] * v;
        into.push_back(strain);
    }
}

void append(const MembraneCell& cell, std::span<const Vec3> x, std::vector<StrainGradient>& into) {
    const auto& p = cell.particles;
    const CellSides sides = cellSides(cell, {x[p[0]], x[p[1]], x[p[2]], x[p[3]]});
    const auto weights = sideWeights(cell);
    const double area = cell.width * cell.height;
    StrainGradient shear{p, {}, area * cell.stiffness.c33};
    const Vec3 xu = 0.5 * (sides[0] + sides[1]), xv = 0.5 * (sides[2] + sides[3]);
    for (int s = 0; s < 4; ++s) {
        const double modulus = s < 2 ? cell.stiffness.c11 : cell.stiffness.c22, length = geometry::length(sides[s]);
        StrainGradient strain{p, {}, 0.5 * area * modulus};
        for (int i = 0; i < 4; ++i) {
            if (length > 0) strain.gradient[i] = (weights[s][i] / length) * sides[s];
            shear.gradient[i] += (0.5 * weights[s][i]) * (s < 2 ? xv : xu);
        }
        if (modulus > 0 && length > 0) into.push_back(strain);
    }
    if (shear.stiffness > 0) into.push_back(shear);
}

} // namespace

void strainGradients(const ClothModel& model, std::span<const Vec3> positions, std::vector<StrainGradient>& into) {
    into.clear();
    for (const auto* springs : {&model.structural, &model.shear, &model.elastics, &model.flexion})
        for (const Spring& s : *springs)
            if (s.stiffness > 0) append(s, positions, into);
    for (const auto* stencils : {&model.bending, &model.twist})
        for (const Stencil& s : *stencils)
            if (s.stiffness > 0) append(s, into);
    for (const Hinge& h : model.hinges)
        if (h.stiffness > 0) append(h, positions, into);
    for (const MembraneTriangle& t : model.triangles) append(t, positions, into);
    for (const MembraneCell& cell : model.cells) append(cell, positions, into);
}

} // namespace toile::cloth
