// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <span>
#include <vector>

namespace toile::simulation {

/// Triangles that hang together by their edges: a garment, or one of several in a pattern.
using ClothPart = std::vector<geometry::TriangleIndices>;

/// The cloth in parts; triangles that merging made degenerate are left out.
[[nodiscard]] std::vector<ClothPart> partsOf(std::span<const geometry::TriangleIndices> triangles);

/// Which triangles to turn over so that neighbours run through their common edge in opposite directions, seen from the
/// first triangle of the part. A part that is one-sided, as a Möbius band is, keeps edges where they do not.
[[nodiscard]] std::vector<bool> turnedAgainstFirst(const ClothPart& part);

/// The triangles of a mesh in regions that hang together by edges of two triangles, which run through them in opposite
/// directions, and that nothing passes through: a way just before a region, from triangle to triangle, meets no
/// surface. A triangle that another passes through is a region of its own. Each triangle has three corners.
[[nodiscard]] std::vector<std::vector<int>> unpiercedRegions(const geometry::TriangleMesh& mesh);

} // namespace toile::simulation
