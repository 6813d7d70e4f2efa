// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/TriangleForces.h"

#include "core/cloth/Tension.h"

namespace toile::cloth {
namespace {

struct Response {
    TensionResponse weft, warp;
};

Response responseTo(const ClothModel& model, const MembraneTriangle& triangle, const Symmetric2& strain) {
    static const std::vector<material::TensionPoint> linear;
    const TensionCurves* curves = triangle.tension >= 0 ? &model.tensionCurves[triangle.tension] : nullptr;
    return {tensionResponse(curves ? curves->weft : linear, strain.xx),
            tensionResponse(curves ? curves->warp : linear, strain.yy)};
}

Symmetric2 stressOf(const MembraneTriangle& triangle, const Symmetric2& e, const Response& response) {
    const auto& c = triangle.stiffness;
    return {c.c11 * response.weft.stress + c.c12 * e.yy, c.c22 * response.warp.stress + c.c12 * e.xx, 2 * c.c33 * e.xy};
}

/// F Z, times two.
DeformationGradient twice(const DeformationGradient& f, const Symmetric2& z) {
    return {2 * (f.u * z.xx + f.v * z.xy), 2 * (f.u * z.xy + f.v * z.yy)};
}

} // namespace

double triangleEnergy(const ClothModel& model, const MembraneTriangle& triangle, const DeformationGradient& f) {
    const Symmetric2 e = Stretch(f).strain();
    const Response response = responseTo(model, triangle, e);
    const auto& c = triangle.stiffness;
    return triangle.area * (c.c11 * response.weft.energy + c.c22 * response.warp.energy + c.c12 * e.xx * e.yy +
                            2 * c.c33 * e.xy * e.xy);
}

DeformationGradient triangleGradient(const ClothModel& model, const MembraneTriangle& triangle,
                                     const DeformationGradient& f) {
    const Stretch stretch(f);
    const Symmetric2 e = stretch.strain();
    const auto gradient = twice(f, stretch.solve(stressOf(triangle, e, responseTo(model, triangle, e))));
    return {triangle.area * gradient.u, triangle.area * gradient.v};
}

std::array<double, 36> triangleHessian(const ClothModel& model, const MembraneTriangle& triangle,
                                       const DeformationGradient& f) {
    const Stretch stretch(f);
    const Symmetric2 e = stretch.strain();
    const Response response = responseTo(model, triangle, e);
    const Symmetric2 z = stretch.solve(stressOf(triangle, e, response));
    const auto& c = triangle.stiffness;
    std::array<double, 36> h{};
    for (int column = 0; column < 6; ++column) {
        DeformationGradient df;
        (column < 3 ? df.u : df.v)[column % 3] = 1;
        const Symmetric2 dc{2 * dot(f.u, df.u), 2 * dot(f.v, df.v), dot(f.u, df.v) + dot(f.v, df.u)};
        const Symmetric2 ds = stretch.solve(dc); // S dS + dS S = dC
        const Symmetric2 dStress{c.c11 * response.weft.tangent * ds.xx + c.c12 * ds.yy,
                                 c.c22 * response.warp.tangent * ds.yy + c.c12 * ds.xx, 2 * c.c33 * ds.xy};
        // S dZ + dZ S = dσ − (dS Z + Z dS)
        const Symmetric2 dz = stretch.solve({dStress.xx - 2 * (ds.xx * z.xx + ds.xy * z.xy),
                                             dStress.yy - 2 * (ds.yy * z.yy + ds.xy * z.xy),
                                             dStress.xy - ((ds.xx + ds.yy) * z.xy + ds.xy * (z.xx + z.yy))});
        const DeformationGradient a = twice(df, z), b = twice(f, dz);
        for (int p = 0; p < 3; ++p) {
            h[column * 6 + p] = triangle.area * (a.u[p] + b.u[p]);
            h[column * 6 + 3 + p] = triangle.area * (a.v[p] + b.v[p]);
        }
    }
    return h;
}

} // namespace toile::cloth
