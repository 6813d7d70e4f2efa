// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/validation/Pieces.h"
#include "tests/collision/Shapes.h"

namespace toile::simulation {

using study::validation::plainCloth;
using study::validation::polygonPiece;
using study::validation::seamBetween;
using study::validation::twoSquares;

/// A table of 1 × 1 m, 0.5 m high, round the vertical through the origin.
inline body::Body box() {
    body::Body body;
    body.name = "box";
    body.mesh = shapes::box({-0.5, 0, -0.5}, {0.5, 0.5, 0.5});
    return body;
}

} // namespace toile::simulation
