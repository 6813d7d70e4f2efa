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

/// A sheet that falls on the table from a height [m].
inline Scene sheetOnTable(double height = 0.51) {
    Scene scene;
    scene.pattern.fabrics.push_back(plainCloth());
    pattern::Piece piece = polygonPiece("sheet", {{0, 0}, {0.3, 0}, {0.3, 0.3}, {0, 0.3}}, 0.03);
    piece.placement = pattern::Placement{};
    piece.placement->transform.origin = {-0.15, height, 0.15};
    piece.placement->transform.axisX = {1, 0, 0};
    piece.placement->transform.axisY = {0, 0, -1};
    piece.placement->transform.axisZ = {0, 1, 0};
    scene.pattern.pieces.push_back(Shared<pattern::Piece>(std::move(piece)));
    scene.body = Shared<body::Body>(box());
    return scene;
}

} // namespace toile::simulation
