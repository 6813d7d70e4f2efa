// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"
#include "core/pattern/Ids.h"

namespace toile::pattern {

// Edits of tacks and buttons. All are pure.

[[nodiscard]] const Tack* findTack(const Pattern& pattern, const TackId& id);
[[nodiscard]] Place placeOf(const Tack& tack);

/// Whether a point of the piece's plane is cloth: within the outline and in no hole, give or take a tenth of a
/// millimetre.
[[nodiscard]] bool isOnCloth(const Pattern& pattern, const Piece& piece, Vec2 point);

/// Holds two places together. Error when one is not on its piece, or when both are the same place.
[[nodiscard]] Result<Pattern> addTack(const Pattern& pattern, const std::array<ClothPoint, 2>& ends, std::string name,
                                      IdSource& ids);
[[nodiscard]] Result<Pattern> removeTack(const Pattern& pattern, const TackId& tack);
/// Moves one end within its piece.
[[nodiscard]] Result<Pattern> moveTackEnd(const Pattern& pattern, const TackId& tack, std::size_t end, Vec2 point);
[[nodiscard]] Result<Pattern> renameTack(const Pattern& pattern, const TackId& tack, std::string name);
/// Makes it a button of this diameter [m]; absent = thread alone.
[[nodiscard]] Result<Pattern> setButtonDiameter(const Pattern& pattern, const TackId& tack,
                                                std::optional<double> diameter);
/// Smaller is closed first, with the seams of the same order.
[[nodiscard]] Result<Pattern> setTackOrder(const Pattern& pattern, const TackId& tack, int order);

} // namespace toile::pattern
