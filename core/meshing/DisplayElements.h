// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"

namespace toile::meshing {

/// What each displayed triangle is cut from: an index into the rectangles, or their number plus one into the triangles.
[[nodiscard]] std::vector<int> displayElements(const PieceMesh& mesh);

/// The region of such an element.
[[nodiscard]] int regionOf(const PieceMesh& mesh, int element);

} // namespace toile::meshing
