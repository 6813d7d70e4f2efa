// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/MembraneCellForces.h"

#include "core/cloth/Tension.h"

namespace toile::cloth {
namespace {

struct Side {
    Vec3 direction;
    double length = 0, strain = 0;
    TensionResponse response;
};

std::array<Side, 4> measured(const ClothModel& model, const MembraneCell& cell, const CellSides& sides) {
    static const std::vector<material::TensionPoint> linear;
    const TensionCurves* curves = cell.tension >= 0 ? &model.tensionCurves[cell.tension] : nullptr;
    std::array<Side, 4> out;
    for (int s = 0; s < 4; ++s) {
        const double length = geometry::length(sides[s]);
        const auto& curve = !curves ? linear : s < 2 ? curves->weft : curves->warp;
        out[s] = {length > 0 ? sides[s] / length : Vec3{}, length, length - 1, tensionResponse(curve, length - 1)};
    }
    return out;
}

double modulus(const MembraneCell& cell, int side) {
    return side < 2 ? cell.stiffness.c11 : cell.stiffness.c22;
}
int across(int side) {
    return side < 2 ? 2 : 0;
} // first of the two sides of the other direction

} // namespace

CellSides cellSides(const MembraneCell& cell, const std::array<Vec3, 4>& p) {
    return {(p[1] - p[0]) / cell.width, (p[2] - p[3]) / cell.width, (p[3] - p[0]) / cell.height,
            (p[2] - p[1]) / cell.height};
}

std::array<std::array<double, 4>, 4> sideWeights(const MembraneCell& cell) {
    const double u = 1 / cell.width, v = 1 / cell.height;
    return {{{-u, u, 0, 0}, {0, 0, u, -u}, {-v, 0, 0, v}, {0, -v, v, 0}}};
}

double cellEnergy(const ClothModel& model, const MembraneCell& cell, const CellSides& sides) {
    const auto s = measured(model, cell, sides);
    const double shear = dot(0.5 * (sides[0] + sides[1]), 0.5 * (sides[2] + sides[3]));
    const auto& c = cell.stiffness;
    return cell.width * cell.height *
           (0.5 * c.c11 * (s[0].response.energy + s[1].response.energy) +
            0.5 * c.c22 * (s[2].response.energy + s[3].response.energy) +
            0.25 * c.c12 * (s[0].strain + s[1].strain) * (s[2].strain + s[3].strain) + 0.5 * c.c33 * shear * shear);
}

CellSides cellGradient(const ClothModel& model, const MembraneCell& cell, const CellSides& sides) {
    const auto s = measured(model, cell, sides);
    const Vec3 xu = 0.5 * (sides[0] + sides[1]), xv = 0.5 * (sides[2] + sides[3]);
    const double shear = dot(xu, xv), area = cell.width * cell.height;
    CellSides gradient;
    for (int i = 0; i < 4; ++i) {
        const int j = across(i);
        const double tension =
            0.5 * modulus(cell, i) * s[i].response.stress + 0.25 * cell.stiffness.c12 * (s[j].strain + s[j + 1].strain);
        gradient[i] = area * (tension * s[i].direction + 0.5 * cell.stiffness.c33 * shear * (i < 2 ? xv : xu));
    }
    return gradient;
}

std::array<double, 144> cellHessian(const ClothModel& model, const MembraneCell& cell, const CellSides& sides) {
    const auto s = measured(model, cell, sides);
    const Vec3 xu = 0.5 * (sides[0] + sides[1]), xv = 0.5 * (sides[2] + sides[3]);
    const double shear = dot(xu, xv), area = cell.width * cell.height;
    const auto& c = cell.stiffness;
    std::array<double, 144> h{};
    const auto at = [&](int i, int p, int j, int q) -> double& { return h[(3 * j + q) * 12 + 3 * i + p]; };
    for (int i = 0; i < 4; ++i) {
        const int a = across(i);
        const double tension =
            0.5 * modulus(cell, i) * s[i].response.stress + 0.25 * c.c12 * (s[a].strain + s[a + 1].strain);
        const double overLength = s[i].length > 1e-9 ? tension / s[i].length : 0;
        const double along = 0.5 * modulus(cell, i) * s[i].response.tangent - overLength;
        for (int j = 0; j < 4; ++j) {
            const bool sameDirection = (i < 2) == (j < 2);
            const Vec3 &gi = i < 2 ? xv : xu, &gj = j < 2 ? xv : xu;
            for (int p = 0; p < 3; ++p)
                for (int q = 0; q < 3; ++q) {
                    double value = 0.25 * c.c33 * gi[p] * gj[q];
                    if (i == j) value += along * s[i].direction[p] * s[i].direction[q] + (p == q ? overLength : 0);
                    if (!sameDirection)
                        value +=
                            0.25 * c.c12 * s[i].direction[p] * s[j].direction[q] + (p == q ? 0.25 * c.c33 * shear : 0);
                    at(i, p, j, q) = area * value;
                }
        }
    }
    return h;
}

} // namespace toile::cloth
