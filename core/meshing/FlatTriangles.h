// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GridPoint.h"
#include "core/meshing/TriangleSides.h"

#include <span>

namespace toile::meshing {

/// Turns the longest side of those of these triangles that are flat, where that gives two that are not turned over.
/// Nodes of one straight edge are collinear but for the rounding of the grid; where no other node is near, a Delaunay
/// triangulation within walls may hold a triangle of three of them, which has an area on the grid alone.
/// Says whether it turned any.
bool turnFlatTriangles(std::span<const int> triangles, std::span<const GridPoint> points, TriangleSides& sides);

} // namespace toile::meshing
