// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/IntegerLines.h"

#include <span>

namespace toile::meshing {

/// A segment of the polygon that is meshed; inside on its left.
struct BorderSegment {
    GridPoint a, b;
    int nodeA = 0, nodeB = 0;
    bool isFold = false; ///< inside on its right as well
};

/// The sides of closed rings, and of folds both ways, and which of them each row of main cells meets. Buffers are kept
/// between calls.
class BorderSegments {
public:
    void assign(const BoundaryNodes& boundary, const IntegerLines& lines);
    void assign(const std::vector<std::vector<GridPoint>>& rings, const IntegerLines& lines);

    [[nodiscard]] std::span<const BorderSegment> all() const { return segments_; }
    /// Where the line y, which lies in this row, enters the inside and leaves it, rising: the first integer x to the
    /// right of each crossing, by the half-open rule y_min ≤ y < y_max. Valid until the next call.
    [[nodiscard]] std::span<const std::int64_t> crossings(std::int32_t y, int row);

private:
    void sortIntoRows(const IntegerLines& lines);

    std::vector<BorderSegment> segments_;
    std::vector<int> firstOfRow_, byRow_;
    std::vector<std::int64_t> crossings_;
};

/// Marks the main cells that meet the piece.
void markActiveCells(const IntegerLines& lines, BorderSegments& segments, Lattice& lattice);

} // namespace toile::meshing
