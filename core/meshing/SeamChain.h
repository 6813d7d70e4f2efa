// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Arena.h"
#include "core/base/Result.h"
#include "core/meshing/PieceBoundary.h"

#include <array>
#include <vector>

namespace toile::meshing {

/// One part of a seam's side, by arc length along the chain.
struct ChainPart {
    SeamPartInput part;
    double start = 0, length = 0; ///< [m]

    /// Arc length along the chain of a fraction of the edge, and back.
    [[nodiscard]] double chainOf(double fraction) const;
    [[nodiscard]] double fractionOf(double chain) const;
};

/// One side of a seam.
struct SeamChain {
    std::pmr::vector<ChainPart> parts;
    double length = 0; ///< [m]
};

/// A place that both sides share: arc length along A, along B.
using SeamAnchor = std::array<double, 2>;

struct CheckedSeam {
    std::array<SeamChain, 2> sides;
    std::pmr::vector<SeamAnchor>
        anchors;     ///< rising; first the start, last the end; between them lengths are proportional
    double ease = 0; ///< declared, over all sections [m]

    /// Where a place of one side lies on the other.
    [[nodiscard]] double across(int fromSide, double chain) const;
};

[[nodiscard]] std::string nameOf(const SeamInput& seam);

/// Checks parts, directions and lengths of a seam; pairs its notches and nearby joints. What comes out lives in the
/// arena.
[[nodiscard]] Result<CheckedSeam> checkedSeam(const MeshInput& input, const SeamInput& seam,
                                              const std::vector<PieceBoundary>& boundaries, Arena& arena,
                                              std::vector<Warning>& warnings);

} // namespace toile::meshing
