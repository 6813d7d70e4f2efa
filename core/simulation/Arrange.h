// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/pattern/Pattern.h"

namespace toile::simulation {

/// The pattern with its placements, made for one body, carried over to another: each piece keeps its place beside
/// the limb it is nearest to, tubes follow bent limbs, and all start clear of the other body. Unchanged when
/// either body has no limbs.
[[nodiscard]] pattern::Pattern arrangedOn(const pattern::Pattern& pattern, const body::Body& from,
                                          const body::Body& to);

/// The pattern with every piece that would start in the body, or too close to it, moved outward until it is
/// clear; a piece that wraps a limb is widened instead, and a flat piece that is sewn to itself beside an arm or
/// a leg is rolled round it. Pieces of a trouser leg are moved to that leg's side. A piece that cannot be cleared
/// so stays. The order of seams may change: a sleeve that lies over a hand is closed last.
[[nodiscard]] pattern::Pattern startingClearOf(const pattern::Pattern& pattern, const body::Body& body);

} // namespace toile::simulation
