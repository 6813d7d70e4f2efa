// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <span>
#include <vector>

namespace toile::simulation {

/// What closes a garment beside its own cloth.
struct Surroundings {
    std::vector<geometry::TriangleIndices> plackets; ///< of the triangles, those that only fill slits (Plackets.h)
    std::vector<std::vector<Vec3>> limbs;            ///< middle lines: a sleeve goes on along its arm
};

/// The share of the area whose right side is the outside of the garment [–].
///
/// Each part is closed over its openings. The right side is out where the closed surface winds round what is just
/// behind the cloth: once, and not round what is just before it, however deep the folds; more often where layers have
/// passed through each other. What is inside out it winds round the other way, or not at all. Cloth that lies double
/// where it is buttoned is not asked: which side of it the placket passes is chance.
[[nodiscard]] double rightSideOutShare(std::span<const geometry::TriangleIndices> triangles,
                                       const std::vector<Vec3>& positions, const Surroundings& around = {});

} // namespace toile::simulation
