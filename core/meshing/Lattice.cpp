// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Lattice.h"

#include <algorithm>
#include <numeric>

namespace toile::meshing {

void Lattice::lay(std::span<const double> mainX, std::span<const double> mainY) {
    x_.assign(mainX.begin(), mainX.end());
    y_.assign(mainY.begin(), mainY.end());
    active.assign(size(columns()) * size(rows()), 0);
    division.clear();
    region.clear();
}

void Lattice::makeDivisible() {
    if (!division.empty()) return;
    division.assign(active.size(), 1);
    region.assign(active.size(), -1);
}

int Lattice::intervalOf(const std::vector<double>& lines, double value) {
    const auto above = std::upper_bound(lines.begin(), lines.end(), value);
    return std::clamp(static_cast<int>(above - lines.begin()) - 1, 0, static_cast<int>(lines.size()) - 2);
}

double Lattice::between(const std::vector<double>& lines, int interval, int part, int parts) {
    const double low = lines[size(interval)], high = lines[size(interval) + 1];
    if (part == 0) return low;
    if (part == parts) return high;
    return low + (high - low) * part / parts;
}

void Lattice::number() {
    nodeCount_ = cornerCount();
    cellCount_ = (columns() + 2) * (rows() + 2);
    divided_.clear();
    mixed_.clear();
    for (std::size_t c = 0; c < division.size(); ++c)
        if (active[c] && division[c] > 1) divided_.push_back(static_cast<int>(c));
    if (isUniform()) return;
    isMixed_.assign(size(cellCount_), 0);
    for (auto* numbers : {&horizontalNodes_, &verticalNodes_}) numbers->resize(size(cornerCount()));
    for (auto* numbers : {&interiorNodes_, &firstCell_}) numbers->resize(active.size());
    divideSides();
    for (const int c : divided_) {
        const int column = c % columns(), row = c / columns();
        numberNodesOf(column, row);
        firstCell_[size(c)] = cellCount_;
        cellCount_ += divisionOf(c) * divisionOf(c);
        for (const int beside : {0, 1, -1, columns() + 2, -columns() - 2})
            isMixed_[size(wholeCell(column, row) + beside)] = 1;
    }
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column < columns(); ++column)
            if (isMixed_[size(wholeCell(column, row))] && active[size(cell(column, row))])
                mixed_.push_back(cell(column, row));
}

/// A side is divided as the finer of the cells beside it.
void Lattice::divideSides() {
    for (auto* divisions : {&horizontalDivisions_, &verticalDivisions_}) divisions->assign(size(cornerCount()), 1);
    for (const int c : divided_) {
        const int column = c % columns(), row = c / columns(), u = divisionOf(c);
        for (const int line : {row, row + 1}) {
            int& side = horizontalDivisions_[size(corner(column, line))];
            side = std::max(side, u);
        }
        for (const int line : {column, column + 1}) {
            int& side = verticalDivisions_[size(corner(line, row))];
            side = std::max(side, u);
        }
    }
}

/// Nodes within a divided cell and its sides; a side belongs to the cell after it, if that is divided too.
void Lattice::numberNodesOf(int column, int row) {
    const auto take = [&](int& first, int count) {
        first = nodeCount_;
        nodeCount_ += count;
    };
    const int u = divisionOf(column, row);
    take(horizontalNodes_[size(corner(column, row))], horizontalDivision(column, row) - 1);
    take(verticalNodes_[size(corner(column, row))], verticalDivision(column, row) - 1);
    take(interiorNodes_[size(cell(column, row))], (u - 1) * (u - 1));
    if (activeDivision(column, row + 1) <= 1) take(horizontalNodes_[size(corner(column, row + 1))], u - 1);
    if (activeDivision(column + 1, row) <= 1) take(verticalNodes_[size(corner(column + 1, row))], u - 1);
}

int Lattice::horizontalNode(int column, int row, int k) const {
    const int u = horizontalDivision(column, row);
    if (k == 0) return corner(column, row);
    if (k == u) return corner(column + 1, row);
    return horizontalNodes_[size(corner(column, row))] + k - 1;
}

int Lattice::verticalNode(int column, int row, int k) const {
    const int u = verticalDivision(column, row);
    if (k == 0) return corner(column, row);
    if (k == u) return corner(column, row + 1);
    return verticalNodes_[size(corner(column, row))] + k - 1;
}

int Lattice::nodeOfDivided(int column, int row, int a, int b) const {
    const int u = divisionOf(column, row);
    if (b == 0 || b == u) {
        const int line = row + (b == u);
        const int sideDivision = horizontalDivision(column, line);
        return horizontalNode(column, line, sideDivision == u ? a : a * (sideDivision / u));
    }
    if (a == 0 || a == u) {
        const int line = column + (a == u);
        const int sideDivision = verticalDivision(line, row);
        return verticalNode(line, row, sideDivision == u ? b : b * (sideDivision / u));
    }
    return interiorNodes_[size(cell(column, row))] + (b - 1) * (u - 1) + a - 1;
}

void Lattice::nodesOfRow(int column, int row, int b, std::vector<int>& nodes) const {
    const int u = divisionOf(column, row);
    nodes.resize(size(u) + 1);
    if (b > 0 && b < u) {
        const auto sideNode = [&](int line) {
            const int side = corner(line, row), parts = verticalDivisions_[size(side)];
            return verticalNodes_[size(side)] + (parts == u ? b : b * (parts / u)) - 1;
        };
        nodes.front() = sideNode(column);
        nodes.back() = sideNode(column + 1);
        std::iota(nodes.begin() + 1, nodes.end() - 1, interiorNodes_[size(cell(column, row))] + (b - 1) * (u - 1));
        return;
    }
    const int side = corner(column, row + (b > 0));
    nodes.front() = side;
    nodes.back() = side + 1;
    if (u == 1) return;
    const int parts = horizontalDivisions_[size(side)], step = parts == u ? 1 : parts / u;
    for (int a = 1, node = horizontalNodes_[size(side)] - 1 + step; a < u; ++a, node += step) nodes[size(a)] = node;
}

} // namespace toile::meshing
