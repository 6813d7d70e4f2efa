// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Editing.h"

namespace toile::pattern {

// Where pieces start in space. All edits are pure.

/// Absent = not placed: the piece cannot be sewn.
[[nodiscard]] Result<Pattern> setPlacement(const Pattern& pattern, const PieceId& piece,
                                           const std::optional<Placement>& placement);
/// Moves a placed piece by a rigid motion of space.
[[nodiscard]] Result<Pattern> movePlacement(const Pattern& pattern, const PieceId& piece, const Transform& motion);
/// Absent = flat. The axis is made a unit vector; the piece stays where its origin is.
[[nodiscard]] Result<Pattern> setCurl(const Pattern& pattern, const PieceId& piece, const std::optional<Curl>& curl);

/// The placement of a mirror image about the piece's own y axis, so that it lies opposite in space: mirrored in the
/// plane x = 0, which halves a body.
[[nodiscard]] Placement mirrored(const Placement& placement);

/// Farther out: a flat piece the way its right side faces, a curled one wider about the same middle.
[[nodiscard]] Placement movedOutward(const Placement& placement, double way);

/// A rigid motion: orthonormal axes, right-handed, to 1e-6.
[[nodiscard]] bool isRigid(const Transform& transform);
/// Two points at least, no two neighbours in one place, finite numbers.
[[nodiscard]] bool isLine(const BentLine& bent);

} // namespace toile::pattern
