// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"
#include "core/simulation/FindTubes.h"

namespace toile::simulation {

/// The pattern with pieces rolled round their limbs, clear of the body. Which end points down the limb, how a
/// piece is turned about it and how far down it lies follow from what it is sewn to: its seams are as short
/// as they can be, and never twisted. A cuff goes where the wrist of its sleeve will be once that is drawn up
/// into its armhole: over a hand it could not be closed. A piece that cannot be cleared so stays.
[[nodiscard]] pattern::Pattern rolledRound(const pattern::Pattern& pattern, std::vector<Roll> rolls,
                                           const collision::BodySurface& surface);

} // namespace toile::simulation
