// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/Measuring.h"

#include <numbers>

namespace toile::samples {

/// The angle inside the piece at a corner of its outline [°].
inline double cornerDegrees(const pattern::Piece& piece, const pattern::VertexId& vertex) {
    return cornerAngle(piece, vertex) * 180 / std::numbers::pi;
}

} // namespace toile::samples
