// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/values/ShapeOwner.h"

namespace toile::ui {

using namespace pattern;

Vec2 ShapeOwner::point(Vec2 onTable) const {
    const Vec2 local = onTable - tablePosition;
    return mirror ? mirror->lineStart + way(local - mirror->lineStart) : local;
}

std::vector<Vec2> ShapeOwner::points(std::vector<Vec2> onTable) const {
    for (Vec2& each : onTable) each = point(each);
    return onTable;
}

Vec2 ShapeOwner::way(Vec2 onTable) const {
    if (!mirror) return onTable;
    const Vec2 along = normalized(mirror->lineEnd - mirror->lineStart);
    return along * (2 * dot(onTable, along)) - onTable;
}

ShapeOwner shapeOwner(const Pattern& pattern, const PieceId& touched) {
    const Piece* piece = findPiece(pattern, touched);
    if (!piece) return {touched, {}, {}};
    return {piece->mirror ? piece->mirror->source : touched, piece->tablePosition, piece->mirror};
}

} // namespace toile::ui
