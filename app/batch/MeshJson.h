// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/meshing/GarmentMesh.h"

namespace toile::batch {

/// The keys of mesh.json (docs/formats/mesh.md).
[[nodiscard]] Json toJson(const meshing::MeshReport& report);

} // namespace toile::batch
