// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Garment.h"
#include "core/simulation/MeshInputOf.h"

#include <QtGlobal>

namespace toile::simulation {

/// Of a pattern that can be meshed.
inline meshing::GarmentMesh meshOf(const pattern::Pattern& pattern) {
    auto mesh = meshing::meshGarment(*meshInputOf(pattern));
    if (!mesh) qFatal("%s", toString(mesh.error()).c_str());
    return std::move(*mesh);
}

/// With all seams merged, or all open.
inline Result<Garment> tryGarmentOf(const pattern::Pattern& pattern, bool merged = false, bool paper = false) {
    meshing::GarmentMesh mesh = meshOf(pattern);
    std::vector<bool> seams(mesh.seams.size(), merged);
    return makeGarment(pattern, Shared<meshing::GarmentMesh>(std::move(mesh)), std::move(seams), paper);
}

inline Garment garmentOf(const pattern::Pattern& pattern, bool merged = false, bool paper = false) {
    auto garment = tryGarmentOf(pattern, merged, paper);
    if (!garment) qFatal("%s", toString(garment.error()).c_str());
    return std::move(*garment);
}

} // namespace toile::simulation
