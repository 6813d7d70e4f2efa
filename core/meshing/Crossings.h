// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace toile::meshing {

/// A side of a closed ring.
struct RingSegment {
    GridPoint a, b; ///< a ≠ b
    int ring = 0;   ///< which ring
    int index = 0;  ///< position in its ring
    int ringSize = 0;
    int edge = 0; ///< the boundary edge it was cut from
};

/// The segments meet elsewhere than at the common corner of neighbours, or neighbours fold back on one another.
[[nodiscard]] bool segmentsClash(const RingSegment& s, const RingSegment& t);

/// Two segments that meet elsewhere than at the common corner of neighbours, as indices; the pair that comes
/// first. Neighbours that fold back on one another count. Halves the box until few segments are left in it.
[[nodiscard]] std::optional<std::pair<int, int>> firstCrossing(std::span<const RingSegment> segments);

/// All such pairs, sorted.
[[nodiscard]] std::vector<std::pair<int, int>> allCrossings(std::span<const RingSegment> segments);

/// The segments of the closed rings; points of one ring are distinct from their neighbours.
[[nodiscard]] std::vector<RingSegment> segmentsOf(std::span<const std::vector<GridPoint>> rings);

/// The point lies inside by the even-odd rule; points on the border may count either way.
[[nodiscard]] bool isInside(std::span<const GridPoint> ring, GridPoint point);

} // namespace toile::meshing
