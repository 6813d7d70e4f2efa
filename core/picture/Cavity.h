// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"

#include <span>
#include <vector>

namespace toile::picture {

/// A hollow of this radius counts fully [m].
inline constexpr double cavityLength = 0.02;

/// The standard deviation of the Gaussian that curvature is evened out with [m].
inline constexpr double cavityBlur = 0.01;

/// How hollow the right side of a surface is at each vertex, as the sky sees it: the mean curvature × cavityLength,
/// evened out over cavityBlur, clamped to ±1 [–].
///
/// Curvature alone grows with the inverse square of a ripple's length: one of 0.3 mm on 30 mm, as far apart as three
/// nodes of a mesh, would look like a fold of 3 mm on 100 mm, though it hides no part of the sky.
///
/// normals: of unit length, one per vertex.
[[nodiscard]] std::vector<double> cavities(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                           std::span<const geometry::TriangleIndices> triangles);

} // namespace toile::picture
