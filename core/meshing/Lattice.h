// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"
#include "core/meshing/PieceFrame.h"

#include <cstdint>
#include <span>
#include <vector>

namespace toile::meshing {

/// The main lines and what each main cell between them is divided into. Main lines are stored as coordinates
/// of the frame; everything finer is an integer index, so that fine lines contain coarse lines exactly.
///
/// Nodes belong to corners of main cells, to their sides (divided by the finer neighbour) and to their
/// interiors; nodeAt() numbers them.
class Lattice {
public:
    /// Lays main lines anew: no cell is active, divided or of a region.
    void lay(std::span<const double> mainX, std::span<const double> mainY);

    [[nodiscard]] int columns() const { return static_cast<int>(x_.size()) - 1; }
    [[nodiscard]] int rows() const { return static_cast<int>(y_.size()) - 1; }
    [[nodiscard]] const std::vector<double>& mainX() const { return x_; }
    [[nodiscard]] const std::vector<double>& mainY() const { return y_; }
    [[nodiscard]] int cell(int column, int row) const { return row * columns() + column; }
    [[nodiscard]] bool holds(int column, int row) const {
        return column >= 0 && row >= 0 && column < columns() && row < rows();
    }

    /// The main column (row) that a coordinate lies in, clamped to the lattice.
    [[nodiscard]] int columnOf(double x) const { return intervalOf(x_, x); }
    [[nodiscard]] int rowOf(double y) const { return intervalOf(y_, y); }
    [[nodiscard]] double width(int column) const { return x_[size(column) + 1] - x_[size(column)]; }
    [[nodiscard]] double height(int row) const { return y_[size(row) + 1] - y_[size(row)]; }
    [[nodiscard]] double xAt(int column, int a, int u) const { return between(x_, column, a, u); }
    [[nodiscard]] double yAt(int row, int b, int u) const { return between(y_, row, b, u); }

    /// Of each main cell: whether it meets the piece.
    std::vector<char> active;
    /// u of each main cell (a power of two), and its region (−1 = main). Empty as long as no cell is divided and there
    /// are no regions.
    std::vector<std::int32_t> division, region;
    void makeDivisible(); ///< gives each cell u = 1 and no region, if they have none yet

    [[nodiscard]] int divisionOf(int cell) const { return division.empty() ? 1 : division[size(cell)]; }
    [[nodiscard]] int divisionOf(int column, int row) const { return divisionOf(cell(column, row)); }
    [[nodiscard]] int regionOf(int cell) const { return region.empty() ? -1 : region[size(cell)]; }
    [[nodiscard]] int activeDivision(int column, int row) const { ///< 0 where nothing is to be meshed
        if (!holds(column, row)) return 0;
        const int c = cell(column, row);
        return active[size(c)] ? divisionOf(c) : 0;
    }

    /// Numbers the nodes and cells; call when `division` and `active` are final.
    void number();
    [[nodiscard]] bool isUniform() const { return divided_.empty(); } ///< no main cell is divided
    [[nodiscard]] int nodeCount() const { return nodeCount_; }
    [[nodiscard]] int cornerCount() const { return (columns() + 1) * (rows() + 1); } ///< the first nodes
    [[nodiscard]] int corner(int column, int row) const { return row * (columns() + 1) + column; }
    /// Node (a, b) of the u × u division of a main cell, 0 ≤ a, b ≤ u.
    [[nodiscard]] int nodeAt(int column, int row, int a, int b) const {
        return isUniform() ? corner(column + a, row + b) : nodeOfDivided(column, row, a, b);
    }
    /// Nodes (0, b) … (u, b) of it.
    void nodesOfRow(int column, int row, int b, std::vector<int>& nodes) const;
    /// u of the horizontal main side below (vertical: left of) main cell (column, row).
    [[nodiscard]] int horizontalDivision(int column, int row) const {
        return isUniform() ? 1 : horizontalDivisions_[size(corner(column, row))];
    }
    [[nodiscard]] int verticalDivision(int column, int row) const {
        return isUniform() ? 1 : verticalDivisions_[size(corner(column, row))];
    }
    /// Node k of 0 … u of that side.
    [[nodiscard]] int horizontalNode(int column, int row, int k) const;
    [[nodiscard]] int verticalNode(int column, int row, int k) const;

    /// The active main cells that are divided, and those that are or lie beside one; rising.
    [[nodiscard]] const std::vector<int>& dividedCells() const { return divided_; }
    [[nodiscard]] const std::vector<int>& mixedCells() const { return mixed_; }
    [[nodiscard]] bool isMixed(int column, int row) const {
        return !isUniform() && isMixed_[size(wholeCell(column, row))];
    }
    /// Cells are numbered: main cells by rows with a margin of one on all sides, then those of divided ones.
    [[nodiscard]] int wholeCell(int column, int row) const { return (row + 1) * (columns() + 2) + column + 1; }
    [[nodiscard]] int cellAt(int column, int row, int a, int b, int u) const {
        return u == 1 ? wholeCell(column, row) : firstCell_[size(cell(column, row))] + b * u + a;
    }
    [[nodiscard]] int cellCount() const { return cellCount_; }

private:
    static std::size_t size(int i) { return static_cast<std::size_t>(i); }
    static int intervalOf(const std::vector<double>& lines, double value);
    static double between(const std::vector<double>& lines, int interval, int part, int parts);
    [[nodiscard]] int nodeOfDivided(int column, int row, int a, int b) const;
    void divideSides();
    void numberNodesOf(int column, int row);

    std::vector<double> x_, y_;
    std::vector<int> divided_, mixed_;
    std::vector<char> isMixed_;
    std::vector<int> horizontalDivisions_, verticalDivisions_; ///< of the sides that start at each corner
    std::vector<int> interiorNodes_, horizontalNodes_, verticalNodes_, firstCell_; ///< of divided cells only
    int nodeCount_ = 0, cellCount_ = 0;
};

} // namespace toile::meshing
