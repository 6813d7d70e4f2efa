// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <utility>
#include <vector>

/// The referee of the contact stages: it shares no code with them. Corners are snapped to a grid of 2⁻³⁰ m (about
/// 1 nm; coarser only beyond 512 m from the origin), and what holds on the grid is decided without rounding.
/// Triangles include their borders: touching, and lying on each other in a plane, count as meeting.
namespace toile::collision {

/// Pairs of triangles (index in a, index in b) that meet, in rising order. Positions must be finite.
[[nodiscard]] std::vector<std::pair<int, int>> intersectingTriangles(const geometry::TriangleMesh& a,
                                                                     const geometry::TriangleMesh& b);

/// Pairs of triangles of one mesh that meet, in rising order; triangles that have a corner at the same place are
/// neighbours (of one piece, or sewn together) and not compared.
[[nodiscard]] std::vector<std::pair<int, int>> selfIntersectingTriangles(const geometry::TriangleMesh& mesh);

} // namespace toile::collision
