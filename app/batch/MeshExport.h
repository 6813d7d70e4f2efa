// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GarmentMesh.h"
#include "core/pattern/Pattern.h"

#include <filesystem>

namespace toile::batch {

/// Writes the flat meshes of all pieces side by side: .obj in metres, .svg in millimetres, or .png.
[[nodiscard]] Result<void> writeMesh(const std::filesystem::path& file, const pattern::Pattern& pattern,
                                     const meshing::GarmentMesh& mesh);

} // namespace toile::batch
