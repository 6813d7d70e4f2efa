// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/DelaunayFlips.h"
#include "core/meshing/GarmentMesh.h"
#include "core/meshing/GridFill.h"
#include "core/meshing/StripSweep.h"

#include <span>

namespace toile::meshing {

/// A rectangle of the lattice.
struct Cell {
    std::array<int, 4> corners{}; ///< counter-clockwise from (−x, −y) of the frame
    int region = -1;
    int index = 0;    ///< in GridFill::filled
    int hanging = -1; ///< in CellMesh::hanging; −1 = no node lies inside a side
};

/// The nodes inside the sides of a cell that it does not own: between corner i and i + 1, in that order.
using HangingNodes = std::array<std::vector<int>, 4>;

/// The cells of a piece and the border of the strip between them and the piece's border.
struct CellLayer {
    std::vector<Cell> cells;
    std::vector<HangingNodes> hanging;
    std::vector<Wall> walls;     ///< border of the strip
    std::vector<char> held;      ///< of each node: a corner of a cell, or on a side of one
    std::vector<int> stripNodes; ///< those not enclosed by cells, rising
    std::vector<int> stripIndex; ///< of each node of the strip, into stripNodes
};

/// The triangles of the strip over its own nodes, with the buffers that make them.
struct Strip {
    std::vector<GridPoint> points; ///< by stripIndex
    TriangleSides sides;
    std::vector<Wall> walls; ///< by stripIndex
    StripSweep sweep;
    DelaunayFlips flips;
};

/// A piece while it is meshed: nodes, cells, strip triangles; numbers are those of GridFill.
struct CellMesh {
    std::vector<Vec2> position; ///< in the frame [m]
    std::vector<GridPoint> grid;
    int boundaryCount = 0; ///< the first nodes are frozen
    CellLayer layer;
    Strip strip;
    std::vector<Triangle> triangles; ///< of the strip, in its order
};

/// The nodes inside a side of a cell.
[[nodiscard]] std::span<const int> hangingOn(const CellLayer& layer, const Cell& cell, std::size_t side);

/// Collects the filled cells of a lattice with their hanging nodes, and the walls round them.
[[nodiscard]] CellLayer cellLayer(const BoundaryNodes& boundary, const Lattice& lattice, const GridFill& fill);

/// Nodes and cells, the strip still empty.
[[nodiscard]] CellMesh cellMesh(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice,
                                const GridFill& fill);

/// Fills the strip with triangles.
void triangulateStrip(const Lattice& lattice, CellMesh& mesh);

} // namespace toile::meshing
