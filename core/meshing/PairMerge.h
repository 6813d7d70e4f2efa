// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/KeyedNodes.h"
#include "core/meshing/Strip.h"

namespace toile::meshing {

/// Pairs strip triangles whose common quadrilateral has all angles within 45–140°, best first; for display
/// and export alone, the triangles stay. Buffers are kept between calls.
class PairMerger {
public:
    void run(Strip& strip);

private:
    /// A side of the strip; of those that deviate alike the one that is first by its place, which is alike for a piece
    /// and its mirror image, and by its triangles.
    struct Draw {
        std::uint64_t place;
        int a, b, side;
        friend auto operator<=>(const Draw&, const Draw&) = default;
    };

    void judge(const Strip& strip, int side);
    void orderDraws(const Strip& strip);

    /// By the cosine of the angle farthest from a right one, without sign [1e-6]: whole, so that draws are draws.
    std::vector<KeyedNode> candidates_, candidatesBuffer_;
    std::vector<Draw> draws_;
};

} // namespace toile::meshing
