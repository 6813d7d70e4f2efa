// SPDX-License-Identifier: GPL-3.0-or-later
// Which cells a piece fills, once its nodes are known.
#include "core/base/Index.h"
#include "core/meshing/GridFill.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace toile::meshing {
GridFiller::Corners GridFiller::cornersOf(int column, int row, int a, int b) const {
    return {lattice_->nodeAt(column, row, a, b), lattice_->nodeAt(column, row, a + 1, b),
            lattice_->nodeAt(column, row, a + 1, b + 1), lattice_->nodeAt(column, row, a, b + 1)};
}

/// Cells whose corners are all used are filled, but for those that the border disturbs.
void GridFiller::fillCells() {
    std::vector<char>& filled = fill_->filled;
    filled.assign(at(lattice_->cellCount()) + GridFill::margin, 0);
    const int columns = lattice_->columns();
    for (int row = 0; row < lattice_->rows(); ++row) {
        const char* low = fill_->inner.data() + lattice_->corner(0, row);
        const char* high = low + columns + 1;
        char* cell = filled.data() + lattice_->wholeCell(0, row);
        for (int column = 0; column < columns; ++column)
            cell[column] = low[column] & low[column + 1] & high[column] & high[column + 1];
    }
    for (const int main : lattice_->dividedCells()) fillDivided(main);
    decideAtBorder();
    for (const BorderSegment& segment : segments_->all()) blockAt(segment);
}

void GridFiller::fillDivided(int main) {
    const int column = main % lattice_->columns(), row = main / lattice_->columns(), u = lattice_->divisionOf(main);
    fill_->filled[at(lattice_->wholeCell(column, row))] = 0;
    lattice_->nodesOfRow(column, row, 0, nextRowNodes_);
    for (int b = 0, cell = lattice_->cellAt(column, row, 0, 0, u); b < u; ++b) {
        std::swap(rowNodes_, nextRowNodes_);
        lattice_->nodesOfRow(column, row, b + 1, nextRowNodes_);
        for (std::size_t a = 0; a < at(u); ++a, ++cell) {
            const Corners corners{rowNodes_[a], rowNodes_[a + 1], nextRowNodes_[a + 1], nextRowNodes_[a]};
            fill_->filled[at(cell)] = fill_->inner[at(corners[0])] & fill_->inner[at(corners[1])] &
                                      fill_->inner[at(corners[2])] & fill_->inner[at(corners[3])];
            decide(cell, corners);
        }
    }
}

void GridFiller::listNeighbours() {
    before_.assign(boundary_->points.size(), -1);
    after_.assign(boundary_->points.size(), -1);
    for (const BorderSegment& segment : segments_->all()) {
        if (segment.isFold) continue;
        after_[at(segment.nodeA)] = segment.nodeB;
        before_[at(segment.nodeB)] = segment.nodeA;
    }
}

/// Looks at all whole cells that have a border node for a corner.
void GridFiller::decideAtBorder() {
    const IntegerLines& lines = fill_->lines;
    for (const auto& [node, latticeNode] : fill_->aligned) {
        const GridPoint p = boundary_->grid[at(node)];
        const int column1 = lines.x.interval(std::int64_t{p.x} + sameNode + 1);
        const int row1 = lines.y.interval(std::int64_t{p.y} + sameNode + 1);
        for (int row = lines.y.interval(std::int64_t{p.y} - sameNode - 1); row <= row1; ++row)
            for (int column = lines.x.interval(std::int64_t{p.x} - sameNode - 1); column <= column1; ++column)
                decide(lattice_->wholeCell(column, row), cornersOf(column, row, 0, 0));
    }
}

/// A cell with border nodes at all corners may lie outside.
void GridFiller::decide(int cell, const Corners& corners) {
    if (!fill_->filled[at(cell)]) return;
    for (const int corner : corners)
        if (fill_->node[at(corner)] < 0) return; // strictly inside, and nothing comes between
    const auto node = [&](std::size_t i) { return at(fill_->node[at(corners[i])]); };
    const auto grid = [&](int border) { return boundary_->grid[at(border)]; };
    for (const std::size_t i : {3, 2, 1, 0}) {
        if (before_[node(i)] < 0) continue; // inside a fold, where all round is the piece
        fill_->filled[at(cell)] = insideCorner(grid(before_[node(i)]), boundary_->grid[node(i)], grid(after_[node(i)]),
                                               boundary_->grid[node((i + 2) % 4)]);
        return;
    }
}

/// Cells that hold or touch a border segment in any way but by sharing a side or a corner are not filled.
void GridFiller::blockAt(const BorderSegment& segment) {
    const IntegerLines& lines = fill_->lines;
    const auto [lowX, highX] = std::minmax(segment.a.x, segment.b.x);
    const auto [lowY, highY] = std::minmax(segment.a.y, segment.b.y);
    const int column0 = lines.x.interval(std::int64_t{lowX} - sameNode - 1);
    const int column1 = lines.x.interval(std::int64_t{highX} + sameNode + 1);
    const int row0 = lines.y.interval(std::int64_t{lowY} - sameNode - 1);
    const int row1 = lines.y.interval(std::int64_t{highY} + sameNode + 1);
    for (int row = row0; row <= row1; ++row)
        for (int column = column0; column <= column1; ++column) {
            char& whole = fill_->filled[at(lattice_->wholeCell(column, row))];
            if (whole) {
                whole = !disturbs(segment, cornersOf(column, row, 0, 0));
            } else if (lattice_->isMixed(column, row)) {
                const int u = lattice_->activeDivision(column, row);
                if (u > 1) blockIn(segment, column, row, u);
            }
        }
}

void GridFiller::blockIn(const BorderSegment& segment, int column, int row, int u) {
    const IntegerLines& lines = fill_->lines;
    const auto range = [&](std::int32_t p, std::int32_t q, std::int32_t low, std::int32_t high) {
        const double size = static_cast<double>(std::int64_t{high} - low) / u;
        const double first = (static_cast<double>(std::min(p, q)) - low - sameNode) / size;
        const double last = (static_cast<double>(std::max(p, q)) - low + sameNode) / size;
        return std::pair(std::clamp(static_cast<int>(std::floor(first)), 0, u - 1),
                         std::clamp(static_cast<int>(std::floor(last)), 0, u - 1));
    };
    const auto [a0, a1] = range(segment.a.x, segment.b.x, lines.x[column], lines.x[column + 1]);
    const auto [b0, b1] = range(segment.a.y, segment.b.y, lines.y[row], lines.y[row + 1]);
    for (int b = b0; b <= b1; ++b)
        for (int a = a0; a <= a1; ++a) {
            char& filled = fill_->filled[at(lattice_->cellAt(column, row, a, b, u))];
            if (filled) filled = !disturbs(segment, cornersOf(column, row, a, b));
        }
}

GridPoint GridFiller::pointOf(int latticeNode) const {
    const int node = fill_->node[at(latticeNode)];
    return node >= 0 ? boundary_->grid[at(node)] : fill_->gridAt(*lattice_, latticeNode);
}

bool GridFiller::disturbs(const BorderSegment& segment, const Corners& corners) const {
    std::array<GridPoint, 4> quad;
    for (std::size_t i = 0; i < 4; ++i) quad[i] = pointOf(corners[i]);
    const auto cornerAt = [&](GridPoint p) {
        for (int i = 0; i < 4; ++i)
            if (quad[at(i)] == p) return i;
        return -1;
    };
    const auto holds = [&](GridPoint p) { // or on a side, which lies beside the nodes on it as its corners do
        for (std::size_t i = 0; i < 4; ++i) {
            const GridPoint from = quad[i], to = quad[(i + 1) % 4];
            const std::int64_t length =
                std::max(std::abs(std::int64_t{to.x} - from.x), std::abs(std::int64_t{to.y} - from.y));
            if (orientation(from, to, p) < -sameNode * length) return false;
        }
        return true;
    };
    const int ca = cornerAt(segment.a), cb = cornerAt(segment.b);
    if ((ca < 0 && holds(segment.a)) || (cb < 0 && holds(segment.b))) return true;
    if (ca >= 0 && cb >= 0) return (ca + cb) % 2 == 0 || (segment.isFold && !lattice_->isUniform()); // a diagonal
    for (int i = 0; i < 4; ++i) {
        if (i != ca && i != cb && onSegment(segment.a, segment.b, quad[at(i)])) return true;
        const int j = (i + 1) % 4;
        const bool shares = i == ca || i == cb || j == ca || j == cb;
        if (!shares && segmentsMeet(segment.a, segment.b, quad[at(i)], quad[at(j)])) return true;
    }
    return false;
}

} // namespace toile::meshing
