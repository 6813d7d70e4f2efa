// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/UpperBlock.h"

#include "core/document/Document.h"

namespace toile::samples {

/// A woman's blouse of poplin: two fronts with a bust dart each, sewn shut down the centre, a back with four regions,
/// sleeves with cuffs, a round neckline, the hem below the seat. Lengths [m].
struct BlouseSettings {
    double spacing = 0.02;                          ///< ε_m of every piece
    UpperBlockSettings block{.hemBelowHip = 0.055}; ///< a hem that ends on the seat catches there
    double bicepsEase = 0.06;
    double bicepsBelow = 0.10; ///< where the arm's girth is taken, beneath the cap's base
    double wristEase = 0.06;   ///< cuff longer than the wrist
    double armEase = 0.01;     ///< sleeve and cuff together longer than the arm
    double cuffWidth = 0.05;
    double frontCapEase = 0.004, backCapEase = 0.0045; ///< above the notches
};

/// Pieces: front-left, front-right, back, sleeve-left, sleeve-right, cuff-left, cuff-right.
[[nodiscard]] document::Document blouse(const body::Measurements& measurements, const body::Body& body,
                                        const BlouseSettings& settings = {});

} // namespace toile::samples
