// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"
#include "core/meshing/PieceFrame.h"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace toile::meshing {

/// A cell within a main cell: column a, row b of its u × u division.
struct CellIndex {
    int column = 0, row = 0; ///< of the main cell
    int a = 0, b = 0;
};

/// The main lines and what each main cell between them is divided into. Main lines are stored as coordinates
/// of the frame; everything finer is an integer index, so that fine lines contain coarse lines exactly.
///
/// Nodes belong to corners of main cells, to their sides (divided by the finer neighbour) and to their
/// interiors; nodeAt() numbers them.
class Lattice {
public:
    Lattice(std::vector<double> mainX, std::vector<double> mainY);

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

    /// u of each main cell (a power of two), its region (−1 = main) and whether it meets the piece.
    std::vector<std::int32_t> division, region;
    std::vector<char> active;
    bool hasRegions = false; ///< some main cell has one

    /// Numbers the nodes; call when `division` and `active` are final.
    void numberNodes();
    [[nodiscard]] bool isUniform() const { return uniform_; } ///< no main cell is divided
    [[nodiscard]] int nodeCount() const { return nodeCount_; }
    /// Node (a, b) of the u × u division of a main cell, 0 ≤ a, b ≤ u.
    [[nodiscard]] int nodeAt(int column, int row, int a, int b) const {
        return uniform_ ? corner(column + a, row + b) : nodeOfDivided(column, row, a, b);
    }
    /// u of the horizontal main side below (vertical: left of) main cell (column, row).
    [[nodiscard]] int horizontalDivision(int column, int row) const;
    [[nodiscard]] int verticalDivision(int column, int row) const;
    /// Node k of 0 … u of that side.
    [[nodiscard]] int horizontalNode(int column, int row, int k) const;
    [[nodiscard]] int verticalNode(int column, int row, int k) const;
    /// First of the u² cells of a main cell in a numbering of all cells.
    [[nodiscard]] int firstCell(int column, int row) const { return firstCell_[size(cell(column, row))]; }
    [[nodiscard]] int cellCount() const { return cellCount_; }
    [[nodiscard]] int divisionOf(int column, int row) const { return division[size(cell(column, row))]; }
    [[nodiscard]] int activeDivision(int column, int row) const { ///< 0 where nothing is to be meshed
        if (!holds(column, row)) return 0;
        const std::size_t c = size(cell(column, row));
        return active[c] ? division[c] : 0;
    }

private:
    static std::size_t size(int i) { return static_cast<std::size_t>(i); }
    static int intervalOf(const std::vector<double>& lines, double value);
    static double between(const std::vector<double>& lines, int interval, int part, int parts);
    [[nodiscard]] int nodeOfDivided(int column, int row, int a, int b) const;
    [[nodiscard]] int corner(int column, int row) const { return row * (columns() + 1) + column; }

    std::vector<double> x_, y_;
    bool uniform_ = true; ///< every u is 1: corners only
    std::vector<int> interiorNodes_, horizontalNodes_, verticalNodes_, firstCell_;
    int nodeCount_ = 0, cellCount_ = 0;
};

} // namespace toile::meshing
