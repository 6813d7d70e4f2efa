// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/CoarseLevels.h"
#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"

#include <memory>

namespace toile::simulation {

/// How many coarse levels a cloth is worth that would need so many substeps: none up to 60, then as many as leave 24 of
/// them, for each level halves their number.
[[nodiscard]] int coarseLevelsFor(int substeps);

/// The surface of a meshed pattern in the words of the hierarchy; nodes of merged seams are one particle. Every piece
/// has its fabric.
[[nodiscard]] dynamics::LevelMesh levelMeshOf(const pattern::Pattern& pattern, const meshing::GarmentMesh& mesh,
                                              const std::vector<bool>& mergedSeams);

/// Meshes of the same pattern at 2, 4, … times the spacing, without its regions.
[[nodiscard]] Result<std::vector<meshing::GarmentMesh>> coarserMeshes(const meshing::MeshInput& fine, int levels);

/// The hierarchy above a garment, its seams merged as the garment's are. Error where a piece cannot be meshed so
/// coarsely, or is narrower than their cells.
[[nodiscard]] Result<std::unique_ptr<dynamics::CoarseLevels>>
levelsOf(const pattern::Pattern& pattern, const MeshOverrides& overrides, const Garment& garment, int levels);

} // namespace toile::simulation
