// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/meshing/MeshInput.h"
#include "core/pattern/Pattern.h"

#include <optional>

namespace toile::simulation {

/// What may be asked of the mesh beside what the document says.
struct MeshOverrides {
    std::optional<double> spacing;               ///< ε_m of every piece [m]
    std::optional<pattern::LineRule> rule;       ///< of every piece
    std::optional<pattern::RegionBorder> border; ///< of every piece
};

/// The pattern in the mesher's own words: mirror pieces resolved, ids turned into indices. Pieces and seams keep
/// their order. Errors name a seam whose piece or edge does not exist.
[[nodiscard]] Result<meshing::MeshInput> meshInputOf(const pattern::Pattern& pattern,
                                                     const MeshOverrides& overrides = {});

} // namespace toile::simulation
