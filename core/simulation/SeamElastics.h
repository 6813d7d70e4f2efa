// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/pattern/Pattern.h"
#include "core/simulation/ParticleMap.h"

namespace toile::simulation {

/// Appends a spring for every stitch of a merged seam with an elastic. A stitch is as long as the shorter of its sides:
/// to that the longer one is drawn up.
void appendSeamElastics(cloth::ClothModel& model, const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                        const std::vector<bool>& mergedSeams, const ParticleMap& particles);

} // namespace toile::simulation
