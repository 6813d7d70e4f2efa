// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"

#include <array>
#include <span>
#include <vector>

namespace toile::cloth {

/// A strain s of an element with the gradient that it has where the cloth is; near there the element holds
/// ½ stiffness·(s − s₀)². Unused places hold particle −1.
struct StrainGradient {
    std::array<int, 4> particles{-1, -1, -1, -1};
    std::array<Vec3, 4> gradient{};
    double stiffness = 0; ///< along the element's own axes, without what couples them
};

/// Those of all elements that have a stiffness, in the order of the model: lengths of springs [m], the three
/// coordinates of stencils, angles of hinges [rad], strains of triangles and of the sides of membrane cells [–], and
/// their shear.
void strainGradients(const ClothModel& model, std::span<const Vec3> positions, std::vector<StrainGradient>& into);

} // namespace toile::cloth
