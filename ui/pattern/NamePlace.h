// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/values/FlatPattern.h"
#include "ui/values/ViewTransform.h"

#include <QLineF>
#include <QRectF>

#include <optional>

namespace toile::ui {

/// Where a name of this size [pixel] hides neither the border of a piece nor its grain line: in the piece, as near
/// below the grain line as there is room; where there is none, under the piece.
[[nodiscard]] QRectF placeOfName(const ViewTransform& view, const FlatPiece& piece, const std::optional<QLineF>& grain,
                                 QSizeF size);

} // namespace toile::ui
