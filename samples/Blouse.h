// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/UpperBlock.h"

#include "core/document/Document.h"

namespace toile::samples {

/// A dart that ends above and below the waist and takes in the hollow between. Lengths [m].
struct WaistDart {
    double fromCentre = 0;
    double intake = 0;           ///< at the waist
    double above = 0, below = 0; ///< from the waist to its tips
};

/// Whom the sample blouse is drafted for: fuller than the usual mannequin, a woman of size EU 42–44.
[[nodiscard]] body::Measurements blouseWearer();

/// A woman's blouse of poplin: two fronts with a bust dart and a waist dart each, sewn shut down the centre, a back
/// with two waist darts and four regions, seven-eighths sleeves with cuffs, a round neckline, the hem below the hip.
/// Lengths [m].
struct BlouseSettings {
    double spacing = 0.02; ///< ε_m of every piece
    UpperBlockSettings block{.bustEase = 0.09,
                             .hipEase = 0.06,
                             .waistSuppression = 0.012,
                             .armholeDepth = 0.21,
                             .backShortening = 0.006,
                             .hipFullness = 0.62,
                             .hemBelowHip = 0.04,
                             .dartIntake = 0.028};
    WaistDart frontWaistDart{.fromCentre = 0.095, .intake = 0.024, .above = 0.13, .below = 0.09};
    WaistDart backWaistDart{.fromCentre = 0.082, .intake = 0.038, .above = 0.145, .below = 0.10};
    double bicepsEase = 0.07;
    double bicepsBelow = 0.10; ///< where the arm's girth is taken, beneath the cap's base
    double cuffEase = 0.11;    ///< cuff longer than the wrist: half of it is what the forearm is thicker where it lies
    double aboveWrist = 0.13;  ///< where the cuff ends
    double cuffWidth = 0.05;
    double frontCapEase = 0.004, backCapEase = 0.0045; ///< above the notches
};

/// Pieces: front-left, front-right, back, sleeve-left, sleeve-right, cuff-left, cuff-right.
/// Error: a measure that no value settles.
[[nodiscard]] Result<document::Document> blouse(const body::Measurements& measurements, const body::Body& body,
                                                const BlouseSettings& settings = {});

} // namespace toile::samples
