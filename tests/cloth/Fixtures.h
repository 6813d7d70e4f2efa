// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Patch.h"
#include "core/cloth/RegularPatches.h"

#include <QtGlobal>
#include <cmath>
#include <random>

namespace toile::fixtures {

using cloth::ClothModel;
using cloth::evenLines;
using cloth::flatPositions;
using cloth::gridPatch;
using cloth::Patch;
using cloth::trianglePatch;
using cloth::twoRegionPatch;
using material::Fabric;

/// Moves every coordinate by a normal deviate times `size`; the same for the same seed.
inline void shake(std::vector<Vec3>& positions, double size, unsigned seed = 7) {
    std::mt19937 random(seed);
    for (Vec3& p : positions)
        for (int i = 0; i < 3; ++i) p[i] += size * (static_cast<double>(random()) / std::mt19937::max() - 0.5) * 2;
}

inline Fabric wovenFabric() {
    return cloth::unequalWeave();
}

inline Fabric knitFabric() {
    Fabric fabric = wovenFabric();
    fabric.name = "test jersey";
    fabric.kind = material::FabricKind::knit;
    fabric.warpStiffness = 40;
    fabric.weftStiffness = 60;
    fabric.shearStiffness = 50;
    fabric.coupling = 15;
    fabric.warpTension = {{0.1, 2}, {0.2, 5}};
    fabric.weftTension = {{0.17, 8}};
    return fabric;
}

inline ClothModel modelOf(const Patch& patch, const Fabric& fabric, cloth::CellForm form = cloth::CellForm::automatic) {
    ClothModel model;
    if (const auto report = cloth::appendPatch(model, patch, fabric, {form}); !report)
        qFatal("%s", toString(report.error()).c_str());
    return model;
}

} // namespace toile::fixtures
