// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/meshing/GarmentMesh.h"
#include "core/simulation/Scene.h"

namespace toile::simulation {

/// About what simulating a garment of this mesh takes, without the factors of linear systems [B].
[[nodiscard]] std::size_t estimatedBytes(const meshing::GarmentMesh& mesh);

/// Error: the garment would take more memory than the scene may, or the machine can give.
[[nodiscard]] Result<void> checkedMemory(const Scene& scene, const meshing::GarmentMesh& mesh);

/// What is left to factors of linear systems [B]; absent = what the machine can give.
[[nodiscard]] std::optional<std::size_t> factorBytesOf(const Scene& scene, const meshing::GarmentMesh& mesh);

} // namespace toile::simulation
