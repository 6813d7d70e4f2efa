// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/meshing/SeamDivision.h"

namespace toile::meshing {

/// Overwrites `nodes` by those along both sides of a seam.
void sew(const CheckedSeam& seam, const BoundaryDivision& division, const std::vector<PieceMesh>& pieces,
         SeamNodes& nodes);

/// How alike the two sides of a seam came out.
[[nodiscard]] SeamReport seamReport(const SeamInput& input, const CheckedSeam& seam, const SeamNodes& nodes,
                                    const BoundaryDivision& division, const std::vector<PieceMesh>& pieces);

} // namespace toile::meshing
