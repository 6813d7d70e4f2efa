// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"

#include <algorithm>
#include <cmath>

namespace toile::cloth {

/// A symmetric 2×2 matrix.
struct Symmetric2 {
    double xx = 0, yy = 0, xy = 0;
};

/// The deformation gradient's columns along weft and warp: |F| = 3×2.
struct DeformationGradient {
    Vec3 u, v;
};

inline DeformationGradient deformationGradient(const MembraneTriangle& t, const Vec3& x0, const Vec3& x1,
                                               const Vec3& x2) {
    const Vec3 p = x1 - x0, q = x2 - x0;
    return {p * t.inverseRest[0] + q * t.inverseRest[2], p * t.inverseRest[1] + q * t.inverseRest[3]};
}

/// Derivative of F's columns by the three corners: ∂F_u/∂x_i = u[i]·I, ∂F_v/∂x_i = v[i]·I.
struct CornerWeights {
    double u[3], v[3];
};

inline CornerWeights cornerWeights(const MembraneTriangle& t) {
    const auto& d = t.inverseRest;
    return {{-d[0] - d[2], d[0], d[2]}, {-d[1] - d[3], d[1], d[3]}};
}

/// The stretch S = √(FᵀF) of a triangle and what follows from it. Biot strain is S − 1.
class Stretch {
public:
    explicit Stretch(const DeformationGradient& f) {
        const double xx = dot(f.u, f.u), yy = dot(f.v, f.v), xy = dot(f.u, f.v);
        const double determinant = std::sqrt(std::max(0.0, xx * yy - xy * xy));
        determinant_ = std::max(determinant, smallest);
        trace_ = std::sqrt(std::max(xx + yy + 2 * determinant, 4 * smallest));
        stretch_ = {(xx + determinant) / trace_, (yy + determinant) / trace_, xy / trace_};
    }

    /// S − 1; the shear angle is 2·xy.
    [[nodiscard]] Symmetric2 strain() const { return {stretch_.xx - 1, stretch_.yy - 1, stretch_.xy}; }

    /// The symmetric Z with S Z + Z S = B: with it d(B : S) = 2 (F Z) : dF.
    [[nodiscard]] Symmetric2 solve(const Symmetric2& b) const {
        // Z = (s·B + (t − S) B (t − S)) / (2 t s), t and s the trace and determinant of S.
        const double p = trace_ - stretch_.xx, r = trace_ - stretch_.yy, q = -stretch_.xy;
        const double c = 1 / (2 * trace_ * determinant_);
        return {c * (determinant_ * b.xx + p * p * b.xx + 2 * p * q * b.xy + q * q * b.yy),
                c * (determinant_ * b.yy + q * q * b.xx + 2 * q * r * b.xy + r * r * b.yy),
                c * (determinant_ * b.xy + p * q * b.xx + (p * r + q * q) * b.xy + q * r * b.yy)};
    }

private:
    static constexpr double smallest = 1e-8; ///< of det S: a triangle collapsed to a line keeps finite forces
    Symmetric2 stretch_;
    double trace_, determinant_;
};

} // namespace toile::cloth
