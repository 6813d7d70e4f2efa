// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"

#include <functional>

namespace toile::body {

/// Negative inside, positive outside, continuous; the same at (x, y, z) and (−x, y, z).
using Field = std::function<double(const Vec3&)>;

struct IsoSurfaceSettings {
    double spacing = 0.0115; ///< of the sampling grid; edges of the mesh come out about as long [m]
    int relaxations = 12;    ///< rounds of evening out the vertices along the surface [–]
    int attempts = 4;        ///< grids tried, each a little shifted, until the mesh is manifold [–]
};

/// The zero surface of a mirror-symmetric field as a closed manifold that is mirror-symmetric to the last
/// bit: surface nets on the half x ≥ 0 (Gibson 1998), relaxed along the surface, then mirrored. Follows the
/// surface from a seed inside the body, so that only cells near the surface are ever sampled; other
/// components are not found. The seed has x = 0.
[[nodiscard]] Result<geometry::TriangleMesh> isoSurface(const Field& field, const Vec3& seed,
                                                        const IsoSurfaceSettings& settings = {});

/// The point of the field's zero near a point, by Newton's steps along the gradient.
[[nodiscard]] Vec3 ontoSurface(const Field& field, Vec3 point, int steps = 3);

} // namespace toile::body
