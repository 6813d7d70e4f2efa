// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/LevelMesh.h"

#include <map>
#include <utility>

namespace toile::dynamics {

/// Which triangle of a mesh holds a material point, and where in it.
class TriangleFinder {
public:
    /// The mesh is borrowed.
    explicit TriangleFinder(const LevelMesh& mesh);

    struct Place {
        int triangle = -1;
        std::array<double, 3> weights{}; ///< of its corners: none negative, sum 1
    };
    /// Of a point beyond the border: the nearest place of the patch.
    [[nodiscard]] Place find(int patch, Vec2 point) const;

private:
    struct Patch {
        std::vector<int> triangles;
        double cell = 1;                                    ///< of the grid [m]
        std::map<std::pair<int, int>, std::vector<int>> in; ///< triangles by grid cell
    };
    const LevelMesh* mesh_;
    std::map<int, Patch> patches_;
};

} // namespace toile::dynamics
