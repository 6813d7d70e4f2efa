// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/pattern/Pattern.h"

#include <span>

namespace toile::simulation {

/// The pattern with every piece that would start inside a piece of a lower layer, or less than 5 mm outside it, moved
/// out: flat pieces along their right side's normal, curled ones widened about their middle. Pieces that lie over
/// nothing, and patterns of one layer, stay as they are.
[[nodiscard]] pattern::Pattern layersApart(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh);

/// How many nodes lie behind a piece of a lower layer that is within 20 mm of them, on its wrong side; not
/// those within 20 mm of a seam that joins the two. nodes: positions as the topology numbers them [m].
[[nodiscard]] int nodesInWrongOrder(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                                    std::span<const Vec3> nodes);

} // namespace toile::simulation
