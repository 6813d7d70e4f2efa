// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/collision/BodySurface.h"
#include "core/simulation/TubePlacing.h"

namespace toile::simulation {

/// The limb whose middle line passes a point nearest. The body has limbs.
[[nodiscard]] body::Limb nearestLimb(const body::Body& body, const Vec3& point);

/// The middle of a placed piece's corners [m].
[[nodiscard]] Vec3 middleOf(const pattern::Piece& piece);

/// A piece that is to be rolled round an arm or a leg.
struct Roll {
    std::size_t piece = 0;   ///< index
    TubePlace place;         ///< as it lies now
    geometry::Polyline limb; ///< its middle line
    double end = 0;          ///< where along it the wrist or the ankle lies [m]
};

/// The flat pieces that are sewn to themselves beside an arm or a leg: sleeves, cuffs. A dart makes no tube.
[[nodiscard]] std::vector<Roll> flatTubesOf(const pattern::Pattern& pattern, const body::Body& body);

/// The curled pieces that wrap an arm or a leg which is bent by a centimetre or more.
[[nodiscard]] std::vector<Roll> tubesOnBentLimbs(const pattern::Pattern& pattern, const body::Body& body);

/// The pattern with pieces rolled round their limbs, clear of the body. Which end points down the limb, how a
/// piece is turned about it and how far down it lies follow from what it is sewn to: its seams are as short
/// as they can be, and never twisted. A cuff goes where the wrist of its sleeve will be once that is drawn up
/// into its armhole: over a hand it could not be closed. A piece that cannot be cleared so stays.
[[nodiscard]] pattern::Pattern rolledRound(const pattern::Pattern& pattern, std::vector<Roll> rolls,
                                           const collision::BodySurface& surface);

} // namespace toile::simulation
