// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/BoundaryNodes.h"
#include "core/meshing/Lattice.h"

namespace toile::meshing {

/// Nodes nearer to the border than this part of their spacing are cleared [–]. Above 0.5 no border segment
/// can cross an edge between two kept nodes.
constexpr double clearance = 0.75;
/// The paper takes every grid point inside; so near to the border its triangles would have no area.
constexpr double paperClearance = 0.05;

/// Which nodes and cells of a lattice the piece fills.
struct GridFill {
    std::vector<GridPoint> at; ///< of each lattice node
    std::vector<int> node;     ///< of each lattice node: the boundary node at its place, a number from
                               ///< boundary-node count on, or −1 if it is not used
    std::vector<Vec2> inner;   ///< positions of the new nodes in the frame [m], by number − boundary-node count
    std::vector<GridPoint> innerGrid;
    std::vector<std::pair<int, Vec2>> aligned; ///< boundary nodes on the lattice and their place in the frame
    std::vector<char> filled;                  ///< of each cell: a rectangle of the mesh
};

/// Marks the main cells that meet the piece.
void markActiveCells(const PieceFrame& frame, const std::vector<std::vector<GridPoint>>& rings, Lattice& lattice);

/// The cells wholly inside the piece, by exact tests; nodes nearer to the border than `cleared` are not used.
[[nodiscard]] GridFill fillLattice(const PieceFrame& frame, const BoundaryNodes& boundary, const Lattice& lattice,
                                   double cleared = clearance);

} // namespace toile::meshing
