// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/meshing/GrainSpans.h"

namespace toile::meshing {

/// Where the main lines of a piece of the rule `paper` cross its border: [loop][edge], rising fractions of
/// arc length strictly between 0 and 1. Crossings nearer than a thousandth of the spacing to one before are
/// left out.
[[nodiscard]] PiecePoints lineCrossings(const PieceInput& piece, const PieceBoundary& boundary, Arena& arena);

} // namespace toile::meshing
