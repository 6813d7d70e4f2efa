// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BorderSegments.h"

namespace toile::meshing {

/// Nodes nearer to the border than this part of their spacing are cleared [–]. Above 0.5 no border segment
/// can cross an edge between two kept nodes.
constexpr double clearance = 0.75;
/// The paper takes every grid point inside; so near to the border its triangles would have no area.
constexpr double paperClearance = 0.05;

/// Which nodes and cells of a lattice the piece fills. Nodes of the mesh are numbered: first the border's, then the
/// lattice's that are used and no border node.
struct GridFill {
    IntegerLines lines;
    std::vector<int> node;        ///< of each lattice node: its number in the mesh, or −1 if it is not used
    std::vector<char> inner;      ///< of each lattice node: used, and no border node
    std::vector<int> latticeNode; ///< of each inner node, by number − border nodes
    std::vector<char> filled;     ///< of each cell (Lattice::cellAt): a rectangle of the mesh
    static constexpr std::size_t margin = 8;  ///< beyond the end of both, so that eight can be read at once
    std::vector<std::pair<int, int>> aligned; ///< border nodes on the lattice, and which of its nodes they are
    std::vector<Vec2> innerPlace;             ///< of the lattice nodes beyond the corners, in the frame [m]
    std::vector<GridPoint> innerGrid;

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
    void numberNodes();
    void fillCells();
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
    double cleared_ = clearance; ///< of the spacing [–]
    int borderCount_ = 0;
    std::vector<int> coarsest_;              ///< smallest u of the main cells that have each node beyond the corners
    std::vector<double> widthAt_, heightAt_; ///< the wider of the cells beside each main line [units]
    std::vector<int> before_, after_;        ///< of each border node in its ring
};

} // namespace toile::meshing
