// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"
#include "core/cloth/HessianSink.h"
#include "core/geometry/Vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace toile::dynamics {

/// A symmetric matrix of 3×3 blocks, of which the lower half is kept. The pattern is learnt from what is
/// added; it only grows.
class BlockMatrix : public cloth::HessianSink {
public:
    explicit BlockMatrix(int blocks) : blocks_(blocks) {}

    void clear(); ///< all values 0, the pattern stays
    /// Adds to block (i, j); of (i, j) and (j, i) the one with i ≥ j is kept, so both must be added.
    void add(int i, int j, const double (&block)[9]) override;
    /// Takes what was added at new places into the pattern. True if it has grown.
    bool settlePattern();

    [[nodiscard]] int blockCount() const { return blocks_; }
    using Key = std::uint64_t; ///< column in the upper half, row in the lower: keys rise as the columns are stored
    [[nodiscard]] static int rowOf(Key key) { return static_cast<int>(key & 0xffffffffu); }
    [[nodiscard]] static int columnOf(Key key) { return static_cast<int>(key >> 32); }
    [[nodiscard]] const std::vector<Key>& pattern() const { return pattern_; } ///< rising; all of the diagonal
    [[nodiscard]] const double* block(std::size_t place) const { return values_.data() + 9 * place; } ///< row-major

    /// result = (A + diag(shift[i]·I))·x. The pattern is settled. team: to share the work of a large matrix with; null
    /// = alone. The bits are the same.
    void multiply(std::span<const double> shift, std::span<const Vec3> x, std::span<Vec3> result,
                  Team* team = nullptr) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    /// Adds what the blocks at these places do to x; result[0] is that of row `first`.
    void multiplyPart(std::size_t begin, std::size_t end, std::span<const Vec3> x, Vec3* result, int first) const;

    static Key keyOf(int row, int column) { return (static_cast<Key>(column) << 32) | static_cast<Key>(row); }

    int blocks_;
    std::vector<Key> pattern_;
    std::vector<double> values_; ///< 9 per block of the pattern
    std::vector<Key> newKeys_;
    std::vector<double> newValues_;
    std::vector<Key> callKeys_;  ///< what the calls of add asked for last time, in their order …
    std::vector<int> callSlots_; ///< … and where it is: assembly repeats itself
    std::size_t call_ = 0;
};

} // namespace toile::dynamics
