// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <cmath>
#include <vector>

namespace toile::dynamics {

using geometry::Vec2;

/// A piece of a cloth's surface between three of its particles.
struct LevelTriangle {
    std::array<int, 3> particles{};
    std::array<Vec2, 3> material{};       ///< u weft, v warp of the corners, in the coordinates of the patch [m]
    int patch = 0;                        ///< only triangles of one patch share coordinates
    double weft = 0, warp = 0, shear = 0; ///< E2, E1, G of the cloth there [N/m]; of the finest mesh alone
};

/// The surface of a cloth at one spacing; every triangle has an area.
struct LevelMesh {
    int particles = 0;
    std::vector<LevelTriangle> triangles;
};

[[nodiscard]] inline double areaOf(const LevelTriangle& t) {
    return 0.5 * std::abs(cross(t.material[1] - t.material[0], t.material[2] - t.material[0]));
}

} // namespace toile::dynamics
