// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridFill.h"
#include "core/meshing/StripSweep.h"

#include <span>

namespace toile::meshing {

/// A rectangle in or beside a divided main cell, where nodes may lie on its sides.
struct MixedCell {
    std::array<int, 4> corners{}; ///< counter-clockwise from (−x, −y) of the frame
    int main = 0;                 ///< the main cell that it is, or is a part of
    int index = 0;                ///< in GridFill::filled
    std::array<int, 5> hanging{}; ///< where the nodes on each side begin, and where the last end

    [[nodiscard]] bool hasHanging() const { return hanging[0] < hanging[4]; }
};

/// What the filled cells leave: the border of the strip between them and the piece's border. Rectangles elsewhere than
/// beside divided main cells are not listed: GridFill says where they are.
struct CellLayer {
    std::vector<int> plain;        ///< divided main cells in the midst of filled ones alike, rising
    std::vector<MixedCell> mixed;  ///< the other rectangles in or beside divided main cells, by main cells
    std::vector<int> hangingNodes; ///< of the mixed cells, side by side
    std::vector<int> stripNodes;   ///< those on walls, and those that neither walls nor cells have
    std::vector<char> isFree;      ///< of each of these: the latter
    std::vector<int> stripIndex;   ///< of each node of the strip, into stripNodes
    std::vector<Wall> walls;       ///< of the strip, by stripIndex

    /// The nodes inside a side of a cell that it does not own, between corner `side` and the next.
    [[nodiscard]] std::span<const int> hangingOn(const MixedCell& cell, std::size_t side) const {
        return std::span(hangingNodes)
            .subspan(static_cast<std::size_t>(cell.hanging[side]),
                     static_cast<std::size_t>(cell.hanging[side + 1] - cell.hanging[side]));
    }
    /// The node's place in stripNodes, where it is added if need be.
    int addToStrip(int node, bool free);
    [[nodiscard]] bool isInStrip(int node) const {
        const auto index = static_cast<std::size_t>(stripIndex[static_cast<std::size_t>(node)]);
        return index < stripNodes.size() && stripNodes[index] == node;
    }
};

/// Collects it. Buffers are kept between calls.
class CellCollector {
public:
    void run(const BoundaryNodes& boundary, const Lattice& lattice, const GridFill& fill, CellLayer& layer);

private:
    /// A directed edge of a cell; two cells share it when it appears both ways.
    struct HalfEdge {
        int low, high;
        bool rising; ///< the cell walks low → high
        friend auto operator<=>(const HalfEdge&, const HalfEdge&) = default;
    };

    void listBorder();
    void collectRow(int row);
    void addWhole(int column, int row);
    void collectMixed();
    void listFull();
    [[nodiscard]] bool isPlain(int column, int row) const;
    void holdNodes(int column, int row, int u);
    void addMixedCells(int main);
    void addMixed(int main, int a, int b, const std::array<int, 4>& corners);
    void addHanging(int column, int row, int a, int b, int u, MixedCell& cell);
    void appendBetween(bool horizontal, int column, int row, int part, int parts);
    void addMixedWalls();
    void addBorderWalls();
    void addFoldWalls();
    [[nodiscard]] bool isSideOfCell(int latticeFrom, int latticeTo) const;
    void addFreeNodes();
    void addSide(int from, int to);
    [[nodiscard]] bool isFilled(int column, int row, int a, int b, int u) const;
    [[nodiscard]] bool isTwin(int column, int row, int a, int b, int u) const;

    const BoundaryNodes* boundary_ = nullptr;
    const Lattice* lattice_ = nullptr;
    const GridFill* fill_ = nullptr;
    CellLayer* layer_ = nullptr;
    int borderCount_ = 0;
    std::vector<int> after_;       ///< of each border node in its ring; −1 inside a fold
    std::vector<char> covered_;    ///< of each border node: the segment from it on is the side of a cell
    std::vector<int> latticeNode_; ///< of each border node: which it is, −1 = none; listed where there are folds
    std::vector<HalfEdge> open_;   ///< sides of mixed cells without a twin of the same size
    std::vector<char> held_;       ///< of each node: on a cell in or beside a divided one
    std::vector<int> full_; ///< of each main cell (Lattice::wholeCell): its u if it is divided and filled, else 0
    std::vector<int> rowNodes_, nextRowNodes_; ///< of a main cell
};

} // namespace toile::meshing
