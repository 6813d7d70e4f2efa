// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/CellLayer.h"

#include <algorithm>
#include <cstring>

namespace toile::meshing {
namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Eight flags at once, each 0 or 1.
std::uint64_t eight(const char* flags) {
    std::uint64_t all = 0;
    std::memcpy(&all, flags, sizeof all);
    return all;
}

} // namespace

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
    layer.mixed.clear();
    layer.hangingNodes.clear();
    layer.stripNodes.clear();
    layer.isFree.clear();
    layer.walls.clear();
    layer.stripIndex.resize(at(borderCount_) + fill.latticeNode.size());
    listBorder();
    for (int row = 0; row < lattice.rows(); ++row) collectRow(row);
    if (!lattice.isUniform()) collectMixed();
    addBorderWalls();
    addFreeNodes();
}

void CellCollector::listBorder() {
    after_.resize(at(borderCount_));
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
    const int* low = fill_->node.data() + lattice_->corner(column, row);
    const int* high = low + lattice_->columns() + 1;
    if (!here[-width]) addSide(low[0], low[1]);
    if (!here[1]) addSide(low[1], high[1]);
    if (!here[width]) addSide(high[1], high[0]);
    if (!here[-1]) addSide(high[0], low[0]);
}

/// The side of one cell only is a wall, unless it is the piece's border.
void CellCollector::addSide(int from, int to) {
    if (from < borderCount_ && after_[at(from)] == to) covered_[at(from)] = 1;
    else layer_->walls.push_back({layer_->addToStrip(to, false), layer_->addToStrip(from, false)});
}

bool CellCollector::isFilled(int column, int row, int a, int b, int u) const {
    return fill_->filled[at(lattice_->cellAt(column, row, a, b, u))];
}

int CellCollector::nodeAt(int column, int row, int a, int b) const {
    return fill_->node[at(lattice_->nodeAt(column, row, a, b))];
}

void CellCollector::collectMixed() {
    open_.clear();
    held_.assign(layer_->stripIndex.size(), 0);
    for (const int main : lattice_->mixedCells()) {
        const int column = main % lattice_->columns(), row = main / lattice_->columns(), u = lattice_->divisionOf(main);
        for (int b = 0; b < u; ++b)
            for (int a = 0; a < u; ++a)
                if (isFilled(column, row, a, b, u)) addMixed(column, row, a, b, u);
    }
    addMixedWalls();
}

void CellCollector::addMixed(int column, int row, int a, int b, int u) {
    MixedCell cell{{nodeAt(column, row, a, b), nodeAt(column, row, a + 1, b), nodeAt(column, row, a + 1, b + 1),
                    nodeAt(column, row, a, b + 1)},
                   lattice_->regionOf(lattice_->cell(column, row)),
                   lattice_->cellAt(column, row, a, b, u),
                   {}};
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
        const int node = fill_->node[at(horizontal ? lattice_->horizontalNode(column, row, k)
                                                   : lattice_->verticalNode(column, row, k))];
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

/// Nodes that lie neither on cells nor on walls.
void CellCollector::addFreeNodes() {
    const int columns = lattice_->columns(), corners = lattice_->cornerCount();
    const std::ptrdiff_t width = columns + 2;
    const auto addIfFree = [&](int latticeNode) {
        const int node = fill_->node[at(latticeNode)];
        if (lattice_->isUniform() || !held_[at(node)]) layer_->addToStrip(node, true);
    };
    for (int row = 0; row <= lattice_->rows(); ++row)
        for (int column = 0; column <= columns; column += 8) {
            const int node = lattice_->corner(column, row);
            const std::uint64_t inner = eight(fill_->inner.data() + node);
            if (inner == 0) continue;
            const char* above = fill_->filled.data() + lattice_->wholeCell(column, row);
            std::uint64_t free =
                inner & ~(eight(above) | eight(above - 1) | eight(above - width) | eight(above - width - 1));
            for (int c = column; free != 0 && c <= columns; free >>= 8, ++c)
                if ((free & 1) != 0) addIfFree(node + c - column);
        }
    for (int node = corners; node < lattice_->nodeCount(); ++node)
        if (fill_->inner[at(node)]) addIfFree(node);
}

} // namespace toile::meshing
