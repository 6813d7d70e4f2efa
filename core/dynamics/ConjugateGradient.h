// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/BlockMatrix.h"

#include <stop_token>

namespace toile::dynamics {

enum class GradientEnd { solved, tooMany, indefinite };

struct GradientReport {
    GradientEnd end = GradientEnd::solved;
    int iterations = 0;
};

/// x ≈ (A + diag(shift[i]·I))⁻¹ b by conjugate gradients from 0, preconditioned with the inverse of each
/// diagonal block, until no |b − (A + shift)x|_i exceeds the tolerance, in the unit of b. Each x on the way
/// minimises the quadratic over its Krylov space, so that xᵀ(A + shift)x = xᵀb. The pattern of A is settled. One that
/// is asked to stop has taken too many.
[[nodiscard]] GradientReport conjugateGradient(const BlockMatrix& matrix, std::span<const double> shift,
                                               std::span<const Vec3> b, double tolerance, int maximumIterations,
                                               std::vector<Vec3>& x, std::stop_token stop = {});

} // namespace toile::dynamics
