// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/Lattice.h"

#include <algorithm>

namespace toile::meshing {

Lattice::Lattice(std::vector<double> mainX, std::vector<double> mainY) : x_(std::move(mainX)), y_(std::move(mainY)) {
    const std::size_t cells = size(columns()) * size(rows());
    division.assign(cells, 1);
    region.assign(cells, -1);
    active.assign(cells, 0);
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

int Lattice::horizontalDivision(int column, int row) const {
    return std::max({1, activeDivision(column, row), activeDivision(column, row - 1)});
}

int Lattice::verticalDivision(int column, int row) const {
    return std::max({1, activeDivision(column, row), activeDivision(column - 1, row)});
}

void Lattice::numberNodes() {
    uniform_ = std::all_of(division.begin(), division.end(), [](int u) { return u == 1; });
    nodeCount_ = (columns() + 1) * (rows() + 1);
    firstCell_.resize(division.size());
    cellCount_ = 0;
    for (std::size_t c = 0; c < division.size(); ++c) {
        firstCell_[c] = cellCount_;
        cellCount_ += active[c] ? division[c] * division[c] : 0;
    }
    if (uniform_) return;
    const auto take = [&](int count) {
        const int first = nodeCount_;
        nodeCount_ += count;
        return first;
    };
    horizontalNodes_.clear();
    for (int row = 0; row <= rows(); ++row)
        for (int column = 0; column < columns(); ++column)
            horizontalNodes_.push_back(take(horizontalDivision(column, row) - 1));
    verticalNodes_.clear();
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column <= columns(); ++column)
            verticalNodes_.push_back(take(verticalDivision(column, row) - 1));
    interiorNodes_.clear();
    for (int row = 0; row < rows(); ++row)
        for (int column = 0; column < columns(); ++column) {
            const int u = std::max(1, activeDivision(column, row));
            interiorNodes_.push_back(take((u - 1) * (u - 1)));
        }
}

int Lattice::horizontalNode(int column, int row, int k) const {
    const int u = horizontalDivision(column, row);
    if (k == 0) return corner(column, row);
    if (k == u) return corner(column + 1, row);
    return horizontalNodes_[size(row * columns() + column)] + k - 1;
}

int Lattice::verticalNode(int column, int row, int k) const {
    const int u = verticalDivision(column, row);
    if (k == 0) return corner(column, row);
    if (k == u) return corner(column, row + 1);
    return verticalNodes_[size(row * (columns() + 1) + column)] + k - 1;
}

int Lattice::nodeOfDivided(int column, int row, int a, int b) const {
    const int u = divisionOf(column, row);
    if (b == 0 || b == u) {
        const int line = row + (b == u);
        return horizontalNode(column, line, a * (horizontalDivision(column, line) / u));
    }
    if (a == 0 || a == u) {
        const int line = column + (a == u);
        return verticalNode(line, row, b * (verticalDivision(line, row) / u));
    }
    return interiorNodes_[size(cell(column, row))] + (b - 1) * (u - 1) + a - 1;
}

} // namespace toile::meshing
