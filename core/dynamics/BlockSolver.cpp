// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BlockSolver.h"

#include "core/dynamics/ConjugateGradient.h"

#include <algorithm>

namespace toile::dynamics {
namespace {

/// Of conjugate gradients that have no factor to fall back on.
constexpr int withoutFactor = 3000;

} // namespace

std::optional<std::vector<Vec3>> BlockSolver::solve(std::span<const double> shift, std::span<const Vec3> b,
                                                    double tolerance, std::stop_token stop) {
    if (refused() > 0) return solveWithoutFactor(shift, b, tolerance, std::move(stop));
    if (gradientIterations_ > 0 && factorOnly_ == 0) {
        matrix_.settlePattern();
        std::vector<Vec3> x;
        const GradientReport tried = conjugateGradient(matrix_, shift, b, tolerance, gradientIterations_, x, stop);
        gradientTotal_ += tried.iterations;
        if (tried.end == GradientEnd::solved) return x;
        if (tried.end == GradientEnd::indefinite || stop.stop_requested()) return std::nullopt;
        factorOnly_ = pause_;
        pause_ = std::min(2 * pause_, 64);
    }
    factorOnly_ = std::max(0, factorOnly_ - 1);
    if (matrix_.factorize(shift))
        if (auto x = matrix_.solve(b)) return x;
    return refused() > 0 ? solveWithoutFactor(shift, b, tolerance, std::move(stop)) : std::nullopt;
}

std::optional<std::vector<Vec3>> BlockSolver::solveWithoutFactor(std::span<const double> shift, std::span<const Vec3> b,
                                                                 double tolerance, std::stop_token stop) {
    matrix_.settlePattern();
    std::vector<Vec3> x;
    const GradientReport tried = conjugateGradient(matrix_, shift, b, tolerance, withoutFactor, x, std::move(stop));
    gradientTotal_ += tried.iterations;
    if (tried.end == GradientEnd::indefinite) return std::nullopt;
    if (tried.end == GradientEnd::tooMany) ++unsolved_;
    return x;
}

} // namespace toile::dynamics
