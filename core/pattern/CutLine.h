// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Brush.h"
#include "core/pattern/Pattern.h"

namespace toile::pattern {

/// What is cut out of the cloth: the piece with the seam allowances of its edges, those of holes into the holes.
/// Corners are mitred where the mitre is not long, else cut off. The piece is resolved. One area, unless the piece's
/// contour crosses itself. A piece a kilometre away gets no allowances.
[[nodiscard]] std::vector<Area> cutShape(const Piece& piece);

} // namespace toile::pattern
