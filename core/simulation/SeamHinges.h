// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/pattern/Pattern.h"
#include "core/simulation/ParticleMap.h"

namespace toile::simulation {

/// Appends a hinge for every edge along which merging joined the borders of two cells. Rest angle and stiffness
/// factor come from the seam. An edge whose two sides run the same way (sewn inside out) gets none.
void appendSeamHinges(cloth::ClothModel& model, const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                      const std::vector<bool>& mergedSeams, const ParticleMap& particles);

} // namespace toile::simulation
