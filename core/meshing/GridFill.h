// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BorderSegments.h"

namespace toile::meshing {

/// Nodes nearer to the border than this part of their spacing are cleared [–]. Above 0.5 no border segment
/// can cross an edge between two kept nodes.
constexpr double clearance = 0.75;
/// The paper takes every grid point inside; so near to the border its triangles would have no area.
constexpr double paperClearance = 0.05;

/// Which nodes and cells of a lattice the piece fills. Nodes are numbered: first the border's, then those of the
/// lattice, used or not.
struct GridFill {
    IntegerLines lines;
    int borderCount = 0;
    std::vector<char> inner;                  ///< of each lattice node: used, and no border node
    std::vector<int> node;                    ///< of each lattice node: the border node that it is, or −1
    std::vector<char> filled;                 ///< of each cell (Lattice::cellAt): a rectangle of the mesh
    static constexpr std::size_t margin = 8;  ///< beyond the end of both, so that eight can be read at once
    std::vector<std::pair<int, int>> aligned; ///< border nodes on the lattice, and which of its nodes they are
    std::vector<Vec2> innerPlace;             ///< of the lattice nodes beyond the corners, in the frame [m]
    std::vector<GridPoint> innerGrid;

    /// The number of a lattice node, −1 if it is not used.
    [[nodiscard]] int nodeAt(int latticeNode) const {
        const auto place = static_cast<std::size_t>(latticeNode);
        return inner[place] ? borderCount + latticeNode : node[place];
    }
    [[nodiscard]] GridPoint gridAt(const Lattice& lattice, int place) const;
    [[nodiscard]] Vec2 placeAt(const Lattice& lattice, int place) const;
};

/// Fills a lattice. Main cells that are not divided are done by rows, the others one by one. Buffers are kept.
class GridFiller {
public:
    /// The cells wholly inside the piece, by exact tests; nodes nearer to the border than `cleared` are not used.
    void run(const PieceFrame& frame, const BoundaryNodes& boundary, BorderSegments& segments, const Lattice& lattice,
             double cleared, GridFill& fill);

private:
    using Corners = std::array<int, 4>;

    void placeDivided();
    void markCorners();
    void markDivided();
    void alignBoundary();
    void measureLines();
    void clearCorners(const BorderSegment& segment);
    void clearDivided(const BorderSegment& segment, int column, int row, int u);
    void clearNearBorder();
    void fillCells();
    void fillDivided(int main);
    void listNeighbours();
    void decideAtBorder();
    void blockAt(const BorderSegment& segment);
    void blockIn(const BorderSegment& segment, int column, int row, int u);
    void decide(int cell, const Corners& corners);
    [[nodiscard]] bool disturbs(const BorderSegment& segment, const Corners& corners) const;
    [[nodiscard]] int coarsestAt(int column, int row) const;
    [[nodiscard]] GridPoint pointOf(int latticeNode) const;
    [[nodiscard]] Corners cornersOf(int column, int row, int a, int b) const;

    const PieceFrame* frame_ = nullptr;
    const BoundaryNodes* boundary_ = nullptr;
    const Lattice* lattice_ = nullptr;
    BorderSegments* segments_ = nullptr;
    GridFill* fill_ = nullptr;
    double cleared_ = clearance;               ///< of the spacing [–]
    std::vector<int> coarsest_;                ///< smallest u of the main cells that have each node beyond the corners
    std::vector<double> widthAt_, heightAt_;   ///< the wider of the cells beside each main line [units]
    std::vector<double> perWidth_, perHeight_; ///< one over them
    std::vector<int> before_, after_;          ///< of each border node in its ring; −1 inside a fold
    std::vector<int> rowNodes_, nextRowNodes_; ///< of a main cell
};

} // namespace toile::meshing
