// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/BlockMatrix.h"
#include "core/dynamics/RoundedFactor.h"

#include <memory>
#include <optional>

namespace toile::dynamics {

/// A block matrix with its supernodal Cholesky factor (CHOLMOD). The pattern is analysed once, and again when
/// it has grown. Runs on one thread.
///
/// A factor that does not fit in memory is refused before its values are made; as patterns only grow, none is tried
/// again.
class BlockCholesky final : public BlockMatrix {
public:
    /// factorBytes: that a factor may take, with its copy in single precision; absent = what the machine can give.
    explicit BlockCholesky(int blocks, std::optional<std::size_t> factorBytes = {});
    ~BlockCholesky() override;
    BlockCholesky(const BlockCholesky&) = delete;
    BlockCholesky& operator=(const BlockCholesky&) = delete;

    /// Factors A + diag(shift[i]·I). False if that is not positive definite, or the factor refused.
    [[nodiscard]] bool factorize(std::span<const double> shift);
    /// x = (A + shift)⁻¹ b of the last factor; not finite where the factor is singular. Absent if
    /// there is no memory for it: then the factor counts as refused.
    [[nodiscard]] std::optional<std::vector<Vec3>> solve(std::span<const Vec3> b);
    /// The last factor; valid until the next.
    [[nodiscard]] SupernodalFactor factor() const;

    /// What a factor would have taken that was refused [B]; 0 = none was.
    [[nodiscard]] std::size_t refused() const { return refused_; }
    [[nodiscard]] int analyses() const { return analyses_; }
    [[nodiscard]] int factorizations() const { return factorizations_; }
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Factor;

    [[nodiscard]] bool analyse();
    [[nodiscard]] bool prepareMatrix();
    [[nodiscard]] std::optional<std::vector<int>> orderOfBlocks();
    [[nodiscard]] std::size_t factorRoom() const;
    [[nodiscard]] bool refuse();
    void writeValues(std::span<const double> shift);

    std::unique_ptr<Factor> factor_;
    std::optional<std::size_t> factorBytes_;
    std::size_t analysedBlocks_ = 0, refused_ = 0;
    int analyses_ = 0, factorizations_ = 0;
};

} // namespace toile::dynamics
