// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Patch.h"
#include "core/meshing/GarmentMesh.h"
#include "core/pattern/Pattern.h"

#include <vector>

namespace toile::simulation {

/// Where a merged seam is gathered, a thread draws up the longer side of every stitch to the length of the shorter,
/// which keeps its own: the fullness lies in the cells beside it. So is declared ease eased in where the shorter side
/// is woven; one of knit, such as a neckband, is stretched to the longer side instead, as both sides' stiffness has it.
/// For every piece its drawn sides, sorted; stitches that differ by less than 0.3 % are left as they are.
[[nodiscard]] std::vector<std::vector<cloth::DrawnSide>>
drawnUp(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh, const std::vector<bool>& mergedSeams);

} // namespace toile::simulation
