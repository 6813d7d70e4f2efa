// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"

#include <array>
#include <vector>

namespace toile::meshing {

/// Turns the longest side of flat triangles where that gives two that are not turned over. Nodes of one
/// straight edge are collinear but for the rounding of the grid; where no other node is near, a Delaunay
/// triangulation within walls may hold a triangle of three of them, which has an area on the grid alone.
void turnFlatTriangles(const std::vector<GridPoint>& points, std::vector<std::array<int, 3>>& triangles);

} // namespace toile::meshing
