// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/Sewing.h"

#include "core/body/Landmarks.h"

namespace toile::samples {

/// Lengths [m].
struct CollarStandSettings {
    double height = 0.028;
    double spacing = 0.01; ///< ε_m
};

/// Half a neckline: from the centre front to the centre back, and what the button stand adds before [m].
struct HalfNeckline {
    double length = 0, extension = 0;
};

/// Edges bottom, back, top, top-extension, end; x = 0 at the centre front, the centre back on +x.
struct CollarStand {
    pattern::Piece left, right;
};

/// A stand in two halves that overlap before, right over left, interfaced; they start as a ring round the neck.
[[nodiscard]] CollarStand draftCollarStand(const pattern::Fabric& fabric, const body::Body& body,
                                           const HalfNeckline& neckline, const CollarStandSettings& settings);

/// Half to half behind; the seam to the neckline is the garment's.
[[nodiscard]] pattern::Seam collarStandSeam(const CollarStand& stand);

} // namespace toile::samples
