// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/HessianSink.h"
#include "core/geometry/Vec.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace toile::dynamics {

/// A symmetric matrix of 3×3 blocks and its supernodal Cholesky factor (CHOLMOD). The pattern is learnt from what is
/// added and analysed once; it only grows. Runs on one thread.
class BlockCholesky : public cloth::HessianSink {
public:
    explicit BlockCholesky(int blocks);
    ~BlockCholesky() override;
    BlockCholesky(const BlockCholesky&) = delete;
    BlockCholesky& operator=(const BlockCholesky&) = delete;

    void clear(); ///< all values 0, the pattern stays
    /// Adds to block (i, j); of (i, j) and (j, i) the one with i ≥ j is kept, so both must be added.
    void add(int i, int j, const double (&block)[9]) override;

    /// Factors A + diag(shift[i]·I). False if that is not positive definite.
    [[nodiscard]] bool factorize(std::span<const double> shift);
    /// x = (A + shift)⁻¹ b of the last factor; not finite where the factor is singular.
    [[nodiscard]] std::vector<Vec3> solve(std::span<const Vec3> b);

    [[nodiscard]] int analyses() const { return analyses_; }
    [[nodiscard]] int factorizations() const { return factorizations_; }
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Factor;
    using Key = std::uint64_t; ///< column in the upper half, row in the lower: keys rise as the columns are stored
    static Key keyOf(int row, int column) { return (static_cast<Key>(column) << 32) | static_cast<Key>(row); }

    void mergeNewBlocks();
    void analyse();
    void writeValues(std::span<const double> shift);

    int blocks_;
    std::vector<Key> pattern_;   ///< rising
    std::vector<double> values_; ///< 9 per block of the pattern, row-major
    std::vector<Key> newKeys_;
    std::vector<double> newValues_;
    std::vector<Key> callKeys_;  ///< what the calls of add asked for last time, in their order …
    std::vector<int> callSlots_; ///< … and where it is: assembly repeats itself
    std::size_t call_ = 0;
    std::unique_ptr<Factor> factor_;
    int analyses_ = 0, factorizations_ = 0;
};

} // namespace toile::dynamics
