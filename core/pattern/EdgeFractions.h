// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

namespace toile::pattern {

// Seams, notches and folds name places by fractions of an edge. When an edge is split or joined they are rewritten, so
// that they stay where they are.

/// `edge` was split at the fraction; its second part is called `after`.
void rewriteAfterSplit(Pattern& pattern, const PieceId& piece, const EdgeId& edge, const EdgeId& after,
                       double fraction);
/// `edge` and `after` became one edge called `edge`, their joint now lies at the fraction. Parts of a seam that had no
/// length are left out, so that a side may be empty.
void rewriteAfterJoin(Pattern& pattern, const PieceId& piece, const EdgeId& edge, const EdgeId& after, double fraction);

/// The part lies on this edge of the piece, or of a mirror image of it.
[[nodiscard]] bool liesOn(const Pattern& pattern, const SeamPart& part, const PieceId& piece, const EdgeId& edge);

} // namespace toile::pattern
