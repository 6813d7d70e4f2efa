// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/CellLayer.h"
#include "core/base/Index.h"

#include "core/meshing/Flags.h"

#include <algorithm>

namespace toile::meshing {
int CellLayer::addToStrip(int node, bool free) {
    if (!isInStrip(node)) {
        stripIndex[at(node)] = static_cast<int>(stripNodes.size());
        stripNodes.push_back(node);
        isFree.push_back(free);
    }
    return stripIndex[at(node)];
}

void CellCollector::run(const BoundaryNodes& boundary, const Lattice& lattice, const GridFill& fill, CellLayer& layer) {
    boundary_ = &boundary;
    lattice_ = &lattice;
    fill_ = &fill;
    layer_ = &layer;
    borderCount_ = static_cast<int>(boundary.points.size());
    layer.plain.clear();
    layer.mixed.clear();
    layer.hangingNodes.clear();
    layer.stripNodes.clear();
    layer.isFree.clear();
    layer.walls.clear();
    layer.stripIndex.resize(at(borderCount_) + fill.node.size());
    listBorder();
    for (int row = 0; row < lattice.rows(); ++row) collectRow(row);
    if (!lattice.isUniform()) collectMixed();
    addBorderWalls();
    addFoldWalls();
    addFreeNodes();
}

void CellCollector::listBorder() {
    after_.assign(at(borderCount_), -1);
    covered_.assign(at(borderCount_), 0);
    for (const auto& ring : boundary_->rings)
        for (std::size_t i = 0; i < ring.size(); ++i) after_[at(ring[i])] = ring[i + 1 < ring.size() ? i + 1 : 0];
}

/// The whole cells of a row that do not have filled ones on all sides.
void CellCollector::collectRow(int row) {
    const std::ptrdiff_t width = lattice_->columns() + 2;
    const char* first = fill_->filled.data() + lattice_->wholeCell(0, row);
    for (int column = 0; column < lattice_->columns(); column += 8) {
        const char* cell = first + column;
        const std::uint64_t filled = eight(cell);
        std::uint64_t open = filled & ~(eight(cell - 1) & eight(cell + 1) & eight(cell - width) & eight(cell + width));
        for (int c = column; open != 0; open >>= 8, ++c)
            if ((open & 1) != 0 && c < lattice_->columns() && !lattice_->isMixed(c, row)) addWhole(c, row);
    }
}

void CellCollector::addWhole(int column, int row) {
    const std::ptrdiff_t width = lattice_->columns() + 2;
    const char* here = fill_->filled.data() + lattice_->wholeCell(column, row);
    const int low = lattice_->corner(column, row), high = low + lattice_->columns() + 1;
    const std::array<int, 4> corners{fill_->nodeAt(low), fill_->nodeAt(low + 1), fill_->nodeAt(high + 1),
                                     fill_->nodeAt(high)};
    if (!here[-width]) addSide(corners[0], corners[1]);
    if (!here[1]) addSide(corners[1], corners[2]);
    if (!here[width]) addSide(corners[2], corners[3]);
    if (!here[-1]) addSide(corners[3], corners[0]);
}

/// The side of one cell only is a wall, unless it is the piece's border.
void CellCollector::addSide(int from, int to) {
    if (from < borderCount_ && after_[at(from)] == to) covered_[at(from)] = 1;
    else layer_->walls.push_back({layer_->addToStrip(to, false), layer_->addToStrip(from, false)});
}

bool CellCollector::isFilled(int column, int row, int a, int b, int u) const {
    return fill_->filled[at(lattice_->cellAt(column, row, a, b, u))];
}

/// Cells in or beside divided ones. What lies in the midst of cells of its size is told by its main cell alone.
void CellCollector::collectMixed() {
    open_.clear();
    held_.assign(layer_->stripIndex.size() + GridFill::margin, 0);
    listFull();
    for (const int main : lattice_->mixedCells()) {
        const int column = main % lattice_->columns(), row = main / lattice_->columns();
        if (isPlain(column, row)) {
            layer_->plain.push_back(main);
            holdNodes(column, row, lattice_->divisionOf(main));
        } else {
            addMixedCells(main);
        }
    }
    addMixedWalls();
}

void CellCollector::listFull() {
    full_.assign(at(lattice_->wholeCell(lattice_->columns(), lattice_->rows()) + 1), 0);
    for (const int main : lattice_->dividedCells()) {
        const int column = main % lattice_->columns(), row = main / lattice_->columns(), u = lattice_->divisionOf(main);
        const auto first = fill_->filled.begin() + lattice_->cellAt(column, row, 0, 0, u);
        if (std::find(first, first + u * u, char{0}) == first + u * u) full_[at(lattice_->wholeCell(column, row))] = u;
    }
}

/// The main cell and all eight round it are filled and divided alike: it has no node of the strip.
bool CellCollector::isPlain(int column, int row) const {
    const std::ptrdiff_t width = lattice_->columns() + 2;
    const int* here = full_.data() + lattice_->wholeCell(column, row);
    const auto isLike = [u = *here](const int* three) { return three[-1] == u && three[0] == u && three[1] == u; };
    return *here > 0 && isLike(here - width) && isLike(here) && isLike(here + width);
}

void CellCollector::holdNodes(int column, int row, int u) {
    for (int b = 0; b <= u; ++b) {
        lattice_->nodesOfRow(column, row, b, rowNodes_);
        for (const int node : rowNodes_) held_[at(borderCount_ + node)] = 1;
    }
}

void CellCollector::addMixedCells(int main) {
    const int column = main % lattice_->columns(), row = main / lattice_->columns(), u = lattice_->divisionOf(main);
    const auto listRow = [&](int b) {
        lattice_->nodesOfRow(column, row, b, nextRowNodes_);
        for (int& node : nextRowNodes_) node = fill_->nodeAt(node);
    };
    listRow(0);
    for (int b = 0; b < u; ++b) {
        std::swap(rowNodes_, nextRowNodes_);
        listRow(b + 1);
        for (int a = 0; a < u; ++a)
            if (isFilled(column, row, a, b, u))
                addMixed(main, a, b,
                         {rowNodes_[at(a)], rowNodes_[at(a) + 1], nextRowNodes_[at(a) + 1], nextRowNodes_[at(a)]});
    }
}

void CellCollector::addMixed(int main, int a, int b, const std::array<int, 4>& corners) {
    const int column = main % lattice_->columns(), row = main / lattice_->columns(), u = lattice_->divisionOf(main);
    MixedCell cell{corners, main, lattice_->cellAt(column, row, a, b, u), {}};
    addHanging(column, row, a, b, u, cell);
    for (const int corner : cell.corners) held_[at(corner)] = 1;
    const std::array<bool, 4> shared{isTwin(column, row, a, b - 1, u), isTwin(column, row, a + 1, b, u),
                                     isTwin(column, row, a, b + 1, u), isTwin(column, row, a - 1, b, u)};
    for (std::size_t side = 0; side < 4; ++side) {
        if (shared[side]) continue;
        int from = cell.corners[side];
        const auto add = [&](int to) {
            open_.push_back({std::min(from, to), std::max(from, to), from < to});
            from = to;
        };
        for (const int node : layer_->hangingOn(cell, side)) add(node);
        add(cell.corners[(side + 1) % 4]);
    }
    layer_->mixed.push_back(cell);
}

void CellCollector::addHanging(int column, int row, int a, int b, int u, MixedCell& cell) {
    std::vector<int>& nodes = layer_->hangingNodes;
    const auto here = [&] { return static_cast<int>(nodes.size()); };
    const int first = cell.hanging[0] = here();
    if (b == 0) appendBetween(true, column, row, a, u);
    cell.hanging[1] = here();
    if (a + 1 == u) appendBetween(false, column + 1, row, b, u);
    cell.hanging[2] = here();
    if (b + 1 == u) appendBetween(true, column, row + 1, a, u);
    std::reverse(nodes.begin() + cell.hanging[2], nodes.end());
    cell.hanging[3] = here();
    if (a == 0) appendBetween(false, column, row, b, u);
    std::reverse(nodes.begin() + cell.hanging[3], nodes.end());
    cell.hanging[4] = here();
    for (auto node = nodes.begin() + first; node != nodes.end(); ++node) held_[at(*node)] = 1;
}

/// Appends the used nodes strictly inside part `part` of `parts` of a main side.
void CellCollector::appendBetween(bool horizontal, int column, int row, int part, int parts) {
    const int u = horizontal ? lattice_->horizontalDivision(column, row) : lattice_->verticalDivision(column, row);
    if (u == parts) return;
    for (int k = part * (u / parts) + 1; k < (part + 1) * (u / parts); ++k) {
        const int node = fill_->nodeAt(horizontal ? lattice_->horizontalNode(column, row, k)
                                                  : lattice_->verticalNode(column, row, k));
        if (node >= 0) layer_->hangingNodes.push_back(node);
    }
}

/// The cell beside is filled and of the same division, so that the whole side is shared.
bool CellCollector::isTwin(int column, int row, int a, int b, int u) const {
    if (a >= 0 && b >= 0 && a < u && b < u) return isFilled(column, row, a, b, u);
    if (a < 0) --column, a = u - 1;
    else if (a == u) ++column, a = 0;
    if (b < 0) --row, b = u - 1;
    else if (b == u) ++row, b = 0;
    return lattice_->activeDivision(column, row) == u && isFilled(column, row, a, b, u);
}

/// Cells of different sizes share a side where each has the same nodes on it.
void CellCollector::addMixedWalls() {
    std::sort(open_.begin(), open_.end());
    for (const HalfEdge& edge : open_)
        if (!std::binary_search(open_.begin(), open_.end(), HalfEdge{edge.low, edge.high, !edge.rising}))
            addSide(edge.rising ? edge.low : edge.high, edge.rising ? edge.high : edge.low);
}

void CellCollector::addBorderWalls() {
    for (const auto& ring : boundary_->rings)
        for (const int node : ring)
            if (!covered_[at(node)])
                layer_->walls.push_back({layer_->addToStrip(node, false), layer_->addToStrip(after_[at(node)], false)});
}

/// Both ways, but for sides of rectangles: those have their walls, if they need any.
void CellCollector::addFoldWalls() {
    if (boundary_->folds.empty()) return;
    latticeNode_.assign(at(borderCount_), -1);
    for (const auto& [node, latticeNode] : fill_->aligned) latticeNode_[at(node)] = latticeNode;
    for (const auto& fold : boundary_->folds)
        for (std::size_t i = 0; i + 1 < fold.size(); ++i) {
            if (isSideOfCell(latticeNode_[at(fold[i])], latticeNode_[at(fold[i + 1])])) continue;
            const int a = layer_->addToStrip(fold[i], false), b = layer_->addToStrip(fold[i + 1], false);
            layer_->walls.push_back({a, b});
            layer_->walls.push_back({b, a});
        }
}

/// Folds are aligned on uniform lattices alone.
bool CellCollector::isSideOfCell(int latticeFrom, int latticeTo) const {
    if (!lattice_->isUniform() || latticeFrom < 0 || latticeTo < 0) return false;
    const int low = std::min(latticeFrom, latticeTo), step = std::max(latticeFrom, latticeTo) - low;
    const int width = lattice_->columns() + 1, column = low % width, row = low / width;
    const auto isFilled = [&](int c, int r) { return fill_->filled[at(lattice_->wholeCell(c, r))] != 0; };
    if (step == 1 && column + 1 < width) return isFilled(column, row) || isFilled(column, row - 1);
    return step == width && (isFilled(column, row) || isFilled(column - 1, row));
}

/// Nodes that lie neither on cells nor on walls.
void CellCollector::addFreeNodes() {
    const int columns = lattice_->columns(), corners = lattice_->cornerCount(), nodes = lattice_->nodeCount();
    const std::ptrdiff_t width = columns + 2;
    const auto addThose = [&](std::uint64_t free, int latticeNode, int end) { // of eight, but none from the end on
        for (; free != 0 && latticeNode < end; free >>= 8, ++latticeNode) {
            const int node = borderCount_ + latticeNode;
            if ((free & 1) != 0 && (lattice_->isUniform() || !held_[at(node)])) layer_->addToStrip(node, true);
        }
    };
    for (int row = 0; row <= lattice_->rows(); ++row)
        for (int column = 0; column <= columns; column += 8) {
            const int node = lattice_->corner(column, row);
            const char* above = fill_->filled.data() + lattice_->wholeCell(column, row);
            std::uint64_t free = eight(fill_->inner.data() + node) & ~eight(above);
            if (free == 0) continue;
            free &= ~(eight(above - 1) | eight(above - width) | eight(above - width - 1));
            addThose(free, node, lattice_->corner(columns + 1, row));
        }
    for (int node = corners; node < nodes; node += 8)
        addThose(eight(fill_->inner.data() + node) & ~eight(held_.data() + borderCount_ + node), node, nodes);
}

} // namespace toile::meshing
