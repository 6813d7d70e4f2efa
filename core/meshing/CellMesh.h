// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/ConstrainedDelaunay.h"
#include "core/meshing/GarmentMesh.h"
#include "core/meshing/GridFill.h"

namespace toile::meshing {

/// A rectangle and the nodes on its sides that it does not own.
struct Cell {
    std::array<int, 4> corners{};            ///< counter-clockwise from (−x, −y) of the frame
    std::array<std::vector<int>, 4> hanging; ///< between corner i and i + 1, in that order
    int region = -1;
    int index = 0; ///< in GridFill::filled
};

/// A piece while it is meshed: nodes, cells, strip triangles; numbers are those of GridFill.
struct CellMesh {
    std::vector<Vec2> position; ///< in the frame [m]
    std::vector<GridPoint> grid;
    int boundaryCount = 0; ///< the first nodes are frozen
    std::vector<Cell> cells;
    std::vector<Constraint> walls; ///< border of the strip; the strip on the left
    std::vector<Triangle> triangles;
};

/// Collects the filled cells of a lattice with their hanging nodes, and the border of the strip between them
/// and the piece's border.
[[nodiscard]] CellMesh cellMesh(const PieceFrame& frame, const BoundaryNodes& boundary,
                                const Lattice& lattice, const GridFill& fill);

/// Fills the strip with triangles.
void triangulateStrip(const Lattice& lattice, CellMesh& mesh);

} // namespace toile::meshing
