// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/CoarseLevels.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"

#include <memory>

namespace toile::simulation {

/// How many coarse levels correct a cloth, and how many substeps are left of those it would need alone.
struct LevelPlan {
    int levels = 0, substeps = 0;
};
struct LevelRule {
    int bearable = 60;   ///< substeps up to which there is none
    int fewest = 24;     ///< substeps that they leave at least
    int most = 30;       ///< levels
    bool oneMore = true; ///< where two levels or more leave over 30, one more leaves 28, if pieces are wide enough
};
/// Each level halves the number of substeps.
[[nodiscard]] LevelPlan levelPlanFor(int substeps, const LevelRule& rule = {});

/// The surface of a meshed pattern in the words of the hierarchy; nodes of merged seams are one particle. Every piece
/// has its fabric.
[[nodiscard]] dynamics::LevelMesh levelMeshOf(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                                              const std::vector<bool>& mergedSeams);

/// Meshes of the same pattern at 2, 4, … times the spacing, without its regions.
[[nodiscard]] Result<std::vector<meshing::GarmentMesh>> coarserMeshes(const meshing::MeshInput& fine, int levels);

/// The hierarchy above a garment, its seams merged as the garment's are. Error where a piece cannot be meshed so
/// coarsely, or is narrower than their cells. inertia: as Xpbd has it.
[[nodiscard]] Result<std::unique_ptr<dynamics::CoarseLevels>> levelsOf(const pattern::Pattern& pattern,
                                                                       const MeshOverrides& overrides,
                                                                       const Garment& garment, int levels,
                                                                       std::span<const double> inertia = {});

} // namespace toile::simulation
