// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"
#include "core/dynamics/FactorKernels.h"
#include "core/geometry/Vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace toile::dynamics {

/// L of a supernodal Cholesky factor PAPᵀ = LLᵀ, as CHOLMOD stores it: supernode s has columns columns[s] …
/// columns[s + 1] − 1 and the rows rows[rowStart[s]] … rows[rowStart[s + 1] − 1], of which its columns are the first;
/// its values stand from values[valueStart[s]] on, column by column.
struct SupernodalFactor {
    std::span<const int> columns, rowStart, valueStart, rows;
    std::span<const int> order; ///< P: row i of PAPᵀ is row order[i] of A
    std::span<const double> values;
};

/// A Cholesky factor rounded to single precision, to precondition with. A solution reads all of L twice, and waits for
/// little else: half the bytes take half the time, and subtrees of the elimination tree are shared out.
///
/// L is read in single and everything is computed in double precision, so what it solves with is exactly symmetric and
/// positive definite whatever was rounded: L̃L̃ᵀ. The bits do not depend on the number of threads.
class RoundedFactor {
public:
    explicit RoundedFactor(const FactorKernels& kernels = fastestFactorKernels()) : kernels_(kernels) {}

    void take(const SupernodalFactor& factor);

    /// x = (L̃L̃ᵀ)⁻¹ b, put into the order of A. team: to share work with; null = alone.
    [[nodiscard]] std::vector<Vec3> solve(std::span<const Vec3> b, Team* team = nullptr);
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Supernode {
        int first = 0, columns = 0; ///< of L
        int rows = 0;               ///< with those of its columns
        int rowStart = 0;           ///< into rows_
        std::int64_t valueStart = 0;
    };
    /// Supernodes first … last − 1, of which none but the last one's parent is above another's.
    struct Subtree {
        int first = 0, last = 0;
    };

    void shareOut(std::span<const int> parents);
    void forward(const Supernode& node, double* x, double* above) const;
    void backward(const Supernode& node, double* x) const;

    const FactorKernels& kernels_;
    std::vector<Supernode> nodes_;
    std::vector<int> rows_, order_;
    std::vector<float> values_;
    std::vector<Subtree> subtrees_;
    std::vector<int> top_;        ///< supernodes above all subtrees, rising
    std::vector<int> placeAbove_; ///< of each row of L among the rows of top_; −1 = none
    int rowsAbove_ = 0;
    std::vector<double> solution_;
    std::vector<std::vector<double>> toAdd_; ///< of each subtree: what it adds to the rows above
};

} // namespace toile::dynamics
