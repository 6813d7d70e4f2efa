// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/material/Fabric.h"

#include <vector>

namespace toile::material {

/// The ten fabrics of Wang, O'Brien, Ramamoorthi 2011: tension, shear and bending measured. 0° of the measurement is
/// taken as warp; thickness and friction were not measured and are estimates.
[[nodiscard]] std::vector<Fabric> measuredFabrics();

/// Everyday fabrics made from measured numbers where there are any. The source text of each says which of its numbers
/// are measured and which are estimates.
[[nodiscard]] std::vector<Fabric> everydayFabrics();

[[nodiscard]] Fabric poplin();  ///< shirts and blouses
[[nodiscard]] Fabric chiffon(); ///< scarves, light skirts
[[nodiscard]] Fabric twill();   ///< trousers, skirts
[[nodiscard]] Fabric denim();   ///< stretch denim of jeans
[[nodiscard]] Fabric jersey();  ///< T-shirts
[[nodiscard]] Fabric rib();     ///< neckbands and cuffs of knits

} // namespace toile::material
