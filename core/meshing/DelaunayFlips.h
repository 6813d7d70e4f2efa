// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"
#include "core/meshing/TriangleSides.h"

#include <span>

namespace toile::meshing {

/// Turns diagonals until each is locally Delaunay. Of four points on one circle the first by (x, y) has it, so that the
/// result depends on the points alone.
class DelaunayFlips {
public:
    /// Looks at all sides.
    void run(std::span<const GridPoint> points, TriangleSides& sides);

private:
    std::vector<int> open_;
};

} // namespace toile::meshing
