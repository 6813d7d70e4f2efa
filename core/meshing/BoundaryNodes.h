// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/meshing/PieceBoundary.h"
#include "core/meshing/SeamDivision.h"

#include <optional>

namespace toile::meshing {

/// Where on the border a segment between two nodes lies.
struct BoundarySpot {
    int loop = 0, edge = 0;
    double fraction = 0;
    friend bool operator==(const BoundarySpot&, const BoundarySpot&) = default;
};

/// The frozen nodes on the border of one piece, numbered along its loops.
struct BoundaryNodes {
    std::vector<Vec2> points; ///< on the curves, bit for bit [m]
    std::vector<GridPoint> grid;
    std::vector<std::vector<EdgeNodes>> loops;    ///< [loop][edge]
    std::vector<std::vector<int>> rings;          ///< closed, the piece on the left
    std::vector<std::vector<BoundarySpot>> spots; ///< of the segment that starts at each ring node
    std::vector<std::vector<int>> folds;          ///< from border to border; their inner nodes come behind the border's
    friend bool operator==(const BoundaryNodes&, const BoundaryNodes&) = default;
};

/// Overwrites the nodes by those that the division gives.
void freezeNodes(const PieceInput& piece, int pieceIndex, const PieceBoundary& boundary,
                 const BoundaryDivision& division, Arena& arena, BoundaryNodes& nodes);

/// Where the polygon through the nodes is no valid border although the curves are: the places to divide
/// finer.
[[nodiscard]] std::pmr::vector<BoundarySpot> spotsTooCoarse(const BoundaryNodes& nodes, Arena& arena);

} // namespace toile::meshing
