// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/Strip.h"

namespace toile::meshing {

/// Cuts cells into triangles for display. Buffers are kept between calls.
class CellTriangulator {
public:
    /// Triangles of a cell with the nodes on its sides: of all triangulations of that polygon the one whose
    /// smallest angle is largest (2:1 neighbours: at least 26.5°).
    std::span<const std::array<int, 3>> of(const CellLayer& layer, const NodePlaces& places, const MixedCell& cell);

private:
    void solve(int i, int j);
    void appendStretch(int i, int j);
    [[nodiscard]] std::size_t slot(int i, int j) const;

    std::vector<int> polygon_;
    std::vector<std::array<int, 3>> triangles_;
    std::vector<Vec2> places_;
    std::vector<double> best_; ///< smallest angle of the best triangulation of each stretch i … j
    std::vector<int> apex_;    ///< and its corner across from i – j
};

} // namespace toile::meshing
