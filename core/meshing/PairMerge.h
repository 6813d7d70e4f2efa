// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/CellMesh.h"

namespace toile::meshing {

/// Pairs strip triangles whose common quadrilateral has all angles within 45–140°, best first; for display
/// and export alone, the triangles stay.
void mergePairs(CellMesh& mesh);

} // namespace toile::meshing
