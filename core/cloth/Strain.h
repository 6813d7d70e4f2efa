// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/cloth/Patch.h"

#include <span>
#include <vector>

namespace toile::cloth {

/// Engineering strain of one element: |x_v| − 1 along warp, |x_u| − 1 along weft, and the shear angle [rad].
struct Strain {
    double warp = 0, weft = 0, shear = 0;
    double area = 0; ///< rest area of the element [m²]
};

/// Of each rectangle, then of each triangle of the patch: mean over the element.
[[nodiscard]] std::vector<Strain> strains(const Patch& patch, std::span<const Vec3> positions);

/// For each element the mean over those whose middles lie within a radius of its own on the flat pattern [m], itself
/// included; areas stay its own. Elements much larger than that are left as they are.
[[nodiscard]] std::vector<Strain> meanStrains(const Patch& patch, std::span<const Strain> strains, double radius);

/// The value of a quantity that `fraction` [0–1] of the area does not exceed.
[[nodiscard]] double areaPercentile(std::vector<std::pair<double, double>> valuesAndAreas, double fraction);

} // namespace toile::cloth
