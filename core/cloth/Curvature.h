// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Patch.h"

#include <span>
#include <vector>

namespace toile::cloth {

/// How a line of rectangles' sides bends out of the cloth at one of its nodes.
struct Curvature {
    double value = 0; ///< positive where the ends lie on the right side of the middle [1/m]
    /// What of it changes its sign from node to node, κ/2 − (κ₋ + κ₊)/4: of a wave that is n cells long the part
    /// (1 − cos 2π/n)/2. Folds that the mesh resolves have little of it [1/m].
    double alternating = 0;
    double area = 0; ///< of the cloth that the node stands for [m²]
    int node = 0;
};

/// Along weft, then along warp, of all nodes that are inner ones of both their lines, as are their neighbours on the
/// line.
[[nodiscard]] std::vector<Curvature> curvatures(const Patch& patch, std::span<const Vec3> positions);

} // namespace toile::cloth
