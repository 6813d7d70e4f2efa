// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/Strip.h"

namespace toile::meshing {

/// Pairs strip triangles whose common quadrilateral has all angles within 45–140°, best first; for display
/// and export alone, the triangles stay. Buffers are kept between calls.
class PairMerger {
public:
    void run(Strip& strip);

private:
    struct Candidate {
        int deviation;       ///< cosine of the angle farthest from a right one, without sign [1e-6]: whole, so that
                             ///< draws are draws
        std::uint64_t place; ///< decides draws, alike for a piece and its mirror image
        int a, b;
        friend auto operator<=>(const Candidate&, const Candidate&) = default;
    };

    void judge(const Strip& strip, int side);

    std::vector<Candidate> candidates_;
};

} // namespace toile::meshing
