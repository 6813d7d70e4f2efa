// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

#include <vector>

namespace toile::simulation {

/// A point of a seam's side.
struct SeamPoint {
    pattern::PieceId piece;
    Vec2 at;
};

/// Points of each side of a seam that are compared with those of the other.
inline constexpr int seamSamples = 9;

/// Equally far apart along a chain of parts, from its first end to its last; none where the pattern has not got its
/// edges.
[[nodiscard]] std::vector<SeamPoint> pointsAlong(const pattern::Pattern& pattern,
                                                 const std::vector<pattern::SeamPart>& chain, int count = seamSamples);

/// The seam joins edges of this one piece.
[[nodiscard]] bool isWithin(const pattern::Seam& seam, const pattern::PieceId& piece);

} // namespace toile::simulation
