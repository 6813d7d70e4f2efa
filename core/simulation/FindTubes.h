// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/simulation/TubePlacing.h"

#include <vector>

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

} // namespace toile::simulation
