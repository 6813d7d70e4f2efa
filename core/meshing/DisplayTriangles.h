// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/CellMesh.h"

namespace toile::meshing {

/// Triangles of a cell with the nodes on its sides: of all triangulations of that polygon the one whose
/// smallest angle is largest (2:1 neighbours: at least 26.5°).
void appendCellTriangles(const CellMesh& mesh, const Cell& cell, std::vector<std::array<int, 3>>& triangles);

/// The smallest angle of the triangle [rad]; 0 if it has no area or runs clockwise.
[[nodiscard]] double smallestAngle(Vec2 a, Vec2 b, Vec2 c);

} // namespace toile::meshing
