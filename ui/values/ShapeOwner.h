// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

#include <optional>

namespace toile::ui {

/// The piece that an edit of a shape changes: the piece itself, or the source of a mirror image. What is done
/// to an image is done to its source, reflected, so that the image follows.
struct ShapeOwner {
    pattern::PieceId piece;
    Vec2 tablePosition;                      ///< of the piece that was touched [m]
    std::optional<pattern::MirrorOf> mirror; ///< of the piece that was touched

    /// A point of the table in the owner's own coordinates.
    [[nodiscard]] Vec2 point(Vec2 onTable) const;
    [[nodiscard]] std::vector<Vec2> points(std::vector<Vec2> onTable) const;
    /// A way on the table, as the owner is to go.
    [[nodiscard]] Vec2 way(Vec2 onTable) const;
};
[[nodiscard]] ShapeOwner shapeOwner(const pattern::Pattern& pattern, const pattern::PieceId& touched);

} // namespace toile::ui
