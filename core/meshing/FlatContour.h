// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Arena.h"
#include "core/meshing/PieceBoundary.h"

#include <memory_resource>
#include <span>
#include <vector>

namespace toile::meshing {

/// A flattened contour and the edge each of its segments comes from.
struct FlatContour {
    std::pmr::vector<GridPoint> points;
    std::pmr::vector<int> edges;
};

/// Straight edges a–b–a bear no cloth: both are marked as collapsed.
void dropSpikes(const PieceInput& piece, int loop, const PieceFrame& frame, Arena& arena, LoopBoundary& boundary);
/// The border of a loop on the integer grid, without the edges that collapsed and without points that coincide.
[[nodiscard]] FlatContour flattenedContour(const PieceInput& piece, int loop, const PieceFrame& frame,
                                           const LoopBoundary& boundary, Arena& arena);
/// Twice the signed area in units², in double: good to its rounding, exact zero for collinear points.
[[nodiscard]] double doubledArea(std::span<const GridPoint> ring);
void turnRound(FlatContour& contour);

} // namespace toile::meshing
