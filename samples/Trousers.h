// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Mannequin.h"
#include "core/document/Document.h"

namespace toile::samples {

/// Straight long trousers of twill on a waistband; a dart in each front and each back. Lengths [m].
struct TrousersSettings {
    double spacing = 0.02; ///< ε_m
    double waistEase = 0.01, hipEase = 0.045, thighEase = 0.055;
    double kneeGirth = 0.53, hemGirth = 0.47;
    double crotchEase = 0.030;    ///< crotch lower than the body's
    double ankleClearance = 0.12; ///< hem above the floor
    double frontDart = 0.015, backDart = 0.030;
    double sideCurve = 0.05; ///< the sides arrive at the waist so much steeper than straight from the hip [rad]
    double waistbandWidth = 0.035;
    double skinOffset = 0.002; ///< a fitted waistband lies closer to the skin than a blouse
    double damping = 2;        ///< a crease over the seat trembles for long with less [1/s]
    int substeps = 160;        ///< of a frame step: the band is pulled tight over the hip
};

/// Heights in the pieces' coordinates at which the trousers are measured: y = 0 is the waist [m].
struct TrouserLevels {
    double hip = 0, thigh = 0, knee = 0;
};
[[nodiscard]] TrouserLevels trouserLevels(const body::Measurements& measurements, const body::Landmarks& landmarks,
                                          const TrousersSettings& settings = {});

/// Pieces: front-left, front-right, back-left, back-right, waistband.
/// Error: a measure that no value settles.
[[nodiscard]] Result<document::Document> trousers(const body::Measurements& measurements, const body::Body& body,
                                                  const TrousersSettings& settings = {});

} // namespace toile::samples
