// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace toile::meshing {

/// An edge that the triangulation must contain, from → to.
struct Constraint {
    int from = 0, to = 0;
    bool fillLeft = false; ///< the wanted region lies to its left
};

/// The constrained Delaunay triangulation of the regions to the left of those constraints that ask for it, up
/// to the next constraint. Points are distinct; constraints meet at common end points only. Triangles are
/// counter-clockwise. All decisions are exact, and the result depends on the set of points alone, not on its
/// order.
[[nodiscard]] std::vector<std::array<int, 3>> constrainedDelaunay(std::span<const GridPoint> points,
                                                                  std::span<const Constraint> constraints);

} // namespace toile::meshing
