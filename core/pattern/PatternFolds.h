// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"
#include "core/pattern/Ids.h"
#include "core/pattern/PatternMeasures.h"

namespace toile::pattern {

// Edits of pressed folds. All are pure, and refuse mirror pieces: their folds are their source's.

[[nodiscard]] const Fold* findFold(const Piece& piece, const FoldId& id);
/// Where an end of a fold lies; none where its edge is unknown. Of a piece as resolved() gives it.
[[nodiscard]] std::optional<Vec2> pointOf(const Piece& piece, const BorderPoint& end);
/// The line of a fold from its first end to its second; empty where an end is unknown.
[[nodiscard]] std::vector<Vec2> pointsOf(const Piece& piece, const Fold& fold);

/// Presses a fold along a line between two places of the border. Error when it leaves the piece.
[[nodiscard]] Result<Pattern> addFold(const Pattern& pattern, const PieceId& piece,
                                      const std::array<BorderPoint, 2>& ends, std::vector<Vec2> between, double angle,
                                      std::string name, IdSource& ids);
[[nodiscard]] Result<Pattern> removeFold(const Pattern& pattern, const PieceId& piece, const FoldId& fold);
[[nodiscard]] Result<Pattern> renameFold(const Pattern& pattern, const PieceId& piece, const FoldId& fold,
                                         std::string name);
/// Sets its rest angle [rad]; 0 = flat, positive closes the right side.
[[nodiscard]] Result<Pattern> pressFold(const Pattern& pattern, const PieceId& piece, const FoldId& fold, double angle);
/// Bending along the fold, of the cloth's [–].
[[nodiscard]] Result<Pattern> setFoldStiffness(const Pattern& pattern, const PieceId& piece, const FoldId& fold,
                                               double factor);
/// Moves an end along the border.
[[nodiscard]] Result<Pattern> moveFoldEnd(const Pattern& pattern, const PieceId& piece, const FoldId& fold,
                                          std::size_t end, const BorderPoint& to);

} // namespace toile::pattern
