// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GrainSpans.h"
#include "core/meshing/Lattice.h"
#include "core/meshing/PieceBoundary.h"

namespace toile::meshing {

/// The coordinates of the main lines, rising; they reach beyond the piece by at least one interval on each
/// side.
struct MainLines {
    std::pmr::vector<double> x, y;
};

/// The main lines of a piece by its rule. seamEnds, in the frame, matter to the rule `features` alone, the
/// stretches of its grain-parallel border to `regular`.
[[nodiscard]] MainLines mainLines(const PieceInput& piece, const PieceBoundary& boundary,
                                  std::span<const Vec2> seamEnds, const GrainStretches& stretches, Arena& arena);

} // namespace toile::meshing
