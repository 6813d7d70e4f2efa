// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/Sewing.h"

#include "core/body/Landmarks.h"

namespace toile::samples {

/// Lengths [m].
struct FoldedCollarSettings {
    double height = 0.05;       ///< behind
    double pointLength = 0.012; ///< by which the points before stand out farther
    double flare = 0.055;       ///< outer edge longer than the seam: it lies on the shoulders
    double foldAngle = 2.97;    ///< pressed into the seam with the stand [rad]
    double spacing = 0.01;      ///< ε_m
};

/// The collar of a shirt, to be sewn on a stand whose top has `length` from centre front to centre front, and let down
/// over it: edges neck, end-right, outer-right, outer-left, end-left; x = 0 at the centre back. It starts turned down,
/// as a ring above a stand whose top is at `top`, its right side inward.
[[nodiscard]] pattern::Piece draftFoldedCollar(const pattern::Fabric& fabric, const body::Body& body, double length,
                                               double top, const FoldedCollarSettings& settings);

} // namespace toile::samples
