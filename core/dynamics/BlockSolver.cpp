// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BlockSolver.h"

#include "core/dynamics/ConjugateGradient.h"

#include <algorithm>

namespace toile::dynamics {

std::optional<std::vector<Vec3>> BlockSolver::solve(std::span<const double> shift, std::span<const Vec3> b,
                                                    double tolerance) {
    if (gradientIterations_ > 0 && factorOnly_ == 0) {
        matrix_.settlePattern();
        std::vector<Vec3> x;
        const GradientReport tried = conjugateGradient(matrix_, shift, b, tolerance, gradientIterations_, x);
        gradientTotal_ += tried.iterations;
        if (tried.end == GradientEnd::solved) return x;
        if (tried.end == GradientEnd::indefinite) return std::nullopt;
        factorOnly_ = pause_;
        pause_ = std::min(2 * pause_, 64);
    }
    factorOnly_ = std::max(0, factorOnly_ - 1);
    if (!matrix_.factorize(shift)) return std::nullopt;
    return matrix_.solve(b);
}

} // namespace toile::dynamics
