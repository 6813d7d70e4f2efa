// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Patch.h"

#include <cstdint>
#include <vector>

namespace toile::cloth {

/// A cell as seen from one of its edges.
struct EdgeSide {
    double from = 0, to = 1; ///< the part of a rectangle's side that this edge is [–]; less than all beside slaves
    int cell = -1;           ///< index into the patch's rectangles or triangles
    bool rectangle = false;
    std::int8_t side = 0; ///< from corner `side` to the next one, counter-clockwise
};

/// A stretch between two neighbouring nodes a → b, counter-clockwise in the first of its sides.
struct PatchEdge {
    int a = 0, b = 0;
    EdgeSide first;
    EdgeSide second; ///< cell −1 at the border of the patch
    [[nodiscard]] bool isInner() const { return second.cell >= 0; }
};

/// All edges in the order of the cells. A rectangle's side that bears slaves is cut at each of them, so that the
/// fine cells beyond find their partner. An edge with a third cell is an error of the mesher.
[[nodiscard]] std::vector<PatchEdge> edgesOf(const Patch& patch);

} // namespace toile::cloth
