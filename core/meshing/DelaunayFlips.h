// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"
#include "core/meshing/TriangleSides.h"

#include <span>

namespace toile::meshing {

/// Turns diagonals until each is locally Delaunay. Of four points on one circle that nearest to the piece's middle has
/// it, so that the result depends on the points alone, and is alike on both sides of a piece that is.
class DelaunayFlips {
public:
    /// Looks at all sides.
    void run(std::span<const GridPoint> points, TriangleSides& sides);
    /// Looks at these, and at what their turning touches.
    void runFrom(std::span<const int> changed, std::span<const GridPoint> points, TriangleSides& sides);
    /// The sides that the last run has turned, with their twins then: the triangles that they are of are others now.
    [[nodiscard]] std::span<const int> turned() const { return turned_; }

private:
    void turnOpen(std::span<const GridPoint> points, TriangleSides& sides);

    std::vector<int> open_, turned_;
};

} // namespace toile::meshing
