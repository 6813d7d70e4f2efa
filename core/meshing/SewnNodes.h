// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/meshing/SeamDivision.h"

namespace toile::meshing {

/// Overwrites `nodes` by those along both sides of a seam.
void sew(const CheckedSeam& seam, const BoundaryDivision& division, const std::vector<PieceMesh>& pieces, Arena& arena,
         SeamNodes& nodes);

/// Overwrites the report by how alike the two sides of a seam came out.
void judgeSeam(const SeamInput& input, const CheckedSeam& seam, const SeamNodes& nodes,
               const BoundaryDivision& division, const std::vector<PieceMesh>& pieces, SeamReport& report);

} // namespace toile::meshing
