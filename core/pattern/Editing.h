// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

#include <functional>
#include <vector>

namespace toile::pattern {

/// A pattern after an edit that had to give something up.
struct Edited {
    Pattern pattern;
    std::vector<Warning> warnings; ///< what was lost or needs a look
};

/// The user's words for a thing, for messages.
[[nodiscard]] Place placeOf(const Piece& piece);
[[nodiscard]] Place placeOf(const Seam& seam);
[[nodiscard]] Place placeOf(const Piece& piece, const Fold& fold);

/// The pattern with one piece changed. Error when the piece is unknown, or when the change returns one.
[[nodiscard]] Result<Pattern> changed(const Pattern& pattern, const PieceId& piece,
                                      const std::function<Result<void>(Piece&)>& change);
/// The same for what a mirror piece takes from its source: refuses mirror pieces.
[[nodiscard]] Result<Pattern> changedShape(const Pattern& pattern, const PieceId& piece,
                                           const std::function<Result<void>(Piece&)>& change);
/// The pattern with one seam changed.
[[nodiscard]] Result<Pattern> changed(const Pattern& pattern, const SeamId& seam,
                                      const std::function<Result<void>(Seam&)>& change);

} // namespace toile::pattern
