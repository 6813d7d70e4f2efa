// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/BlockCholesky.h"

#include <optional>
#include <stop_token>

namespace toile::dynamics {

/// Solves (A + diag(shift[i]·I)) x = b: by conjugate gradients while they need few iterations, else by
/// factoring. When they needed too many, the factor alone serves the next 8 solves, then 16, 32, 64.
/// Where the factor is refused, conjugate gradients go on alone, for as long as they take.
class BlockSolver {
public:
    /// gradientIterations: of conjugate gradients at most; 0 = always factor. factorBytes: as BlockCholesky.
    BlockSolver(int blocks, int gradientIterations, std::optional<std::size_t> factorBytes = {})
        : matrix_(blocks, factorBytes), gradientIterations_(gradientIterations) {}

    [[nodiscard]] BlockCholesky& matrix() { return matrix_; }
    /// Absent if A + shift is found not to be positive definite. tolerance: largest entry of the residual
    /// that conjugate gradients may leave, in the unit of b. Asked to stop it ends early, and x is of no use.
    [[nodiscard]] std::optional<std::vector<Vec3>> solve(std::span<const double> shift, std::span<const Vec3> b,
                                                         double tolerance, std::stop_token stop = {});

    [[nodiscard]] int analyses() const { return matrix_.analyses(); }
    [[nodiscard]] int factorizations() const { return matrix_.factorizations(); }
    [[nodiscard]] int gradientIterations() const { return gradientTotal_; }
    /// Solves without a factor that left more than their tolerance: x still leads downhill.
    [[nodiscard]] int unsolved() const { return unsolved_; }
    [[nodiscard]] std::size_t refused() const { return matrix_.refused(); }
    [[nodiscard]] std::size_t bytes() const { return matrix_.bytes(); }

private:
    [[nodiscard]] std::optional<std::vector<Vec3>>
    solveWithoutFactor(std::span<const double> shift, std::span<const Vec3> b, double tolerance, std::stop_token stop);

    BlockCholesky matrix_;
    int gradientIterations_;
    int gradientTotal_ = 0, unsolved_ = 0;
    int factorOnly_ = 0, pause_ = 8; ///< solves left without, and next time, conjugate gradients
};

} // namespace toile::dynamics
