// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/BlockMatrix.h"
#include "core/dynamics/RoundedFactor.h"

#include <memory>

namespace toile::dynamics {

/// A block matrix with its supernodal Cholesky factor (CHOLMOD). The pattern is analysed once, and again when
/// it has grown. Runs on one thread.
class BlockCholesky final : public BlockMatrix {
public:
    explicit BlockCholesky(int blocks);
    ~BlockCholesky() override;
    BlockCholesky(const BlockCholesky&) = delete;
    BlockCholesky& operator=(const BlockCholesky&) = delete;

    /// Factors A + diag(shift[i]·I). False if that is not positive definite.
    [[nodiscard]] bool factorize(std::span<const double> shift);
    /// x = (A + shift)⁻¹ b of the last factor; not finite where the factor is singular.
    [[nodiscard]] std::vector<Vec3> solve(std::span<const Vec3> b);
    /// The last factor; valid until the next.
    [[nodiscard]] SupernodalFactor factor() const;

    [[nodiscard]] int analyses() const { return analyses_; }
    [[nodiscard]] int factorizations() const { return factorizations_; }
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Factor;

    void analyse();
    [[nodiscard]] std::vector<int> orderOfBlocks();
    void writeValues(std::span<const double> shift);

    std::unique_ptr<Factor> factor_;
    std::size_t analysedBlocks_ = 0;
    int analyses_ = 0, factorizations_ = 0;
};

} // namespace toile::dynamics
