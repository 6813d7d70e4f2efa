// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/meshing/GarmentMesh.h"
#include "core/pattern/Pattern.h"

namespace toile::simulation {

/// The node that a pin holds. The error names the pin: there is no such piece, or no such vertex of it.
[[nodiscard]] Result<meshing::NodeRef> nodeOf(const pattern::Pin& pin, const pattern::Pattern& pattern,
                                              const meshing::GarmentMesh& mesh);

} // namespace toile::simulation
