// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Arena.h"
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
[[nodiscard]] std::optional<std::pair<int, int>> firstCrossing(std::span<const RingSegment> segments, Arena& arena);

/// All such pairs, sorted.
[[nodiscard]] std::pmr::vector<std::pair<int, int>> allCrossings(std::span<const RingSegment> segments, Arena& arena);

/// Appends the segments of a closed ring, whose points are distinct from their neighbours.
void appendSegments(std::span<const GridPoint> ring, int number, std::pmr::vector<RingSegment>& segments);

/// The point lies inside by the even-odd rule; points on the border may count either way.
[[nodiscard]] bool isInside(std::span<const GridPoint> ring, GridPoint point);

} // namespace toile::meshing
