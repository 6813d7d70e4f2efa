// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/pattern/Pattern.h"
#include "core/simulation/Frame.h"

namespace toile::simulation {

/// What the viewers and exporters need to know of a meshed garment.
[[nodiscard]] FrameTopology topologyOf(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh);

/// Where the nodes of all pieces start: each piece by its placement; pieces without one lie in the plane z = 0.
[[nodiscard]] std::vector<Vec3> placedNodes(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh);

} // namespace toile::simulation
