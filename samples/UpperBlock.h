// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/Figures.h"
#include "samples/Strokes.h"

#include <optional>

namespace toile::samples {

/// Eases are added to the whole girth; all lengths [m].
struct UpperBlockSettings {
    double bustEase = 0.09, hipEase = 0.06;
    double acrossBackEase = 0.02;
    double acrossFrontEase = 0.055;  ///< arms held off the body draw the front wide
    double neckGap = 0.008;          ///< between neck and neckline, before and at the sides
    double napeGap = 0.000;          ///< and behind
    double waistSuppression = 0.016; ///< taken in at each side of each half
    double frontMore = -0.004;       ///< half front wider than half back by twice this
    double armholeDepth = 0.20;      ///< nape to underarm
    double backShortening = 0;       ///< above the waist: what a back shaped to the hollow does not bridge
    double hipFullness = 0.35; ///< the side's handle above the hem: how far up it keeps the width of the hip [–]
    double hemBelowHip = 0.01;
    double sideDartAt = 0.075;      ///< below the underarm, measured along the side
    double dartTipDistance = 0.025; ///< from the bust point
    double dartIntake = 0.024;      ///< between the legs at the side; 0 = no dart
};

/// Heights in the pieces' coordinates at which widths are measured [m].
struct UpperLevels {
    double bustFront = 0, bustBack = 0, hipFront = 0, hipBack = 0, acrossBack = 0, acrossFront = 0;
};

/// Half a front and half a back on x ≥ 0, y = 0 at the side neck point, from the bottom centre counter-clockwise to
/// the top centre. Edges: hem, side-hip, side-waist, (dart-lower, dart-upper,) side-top, armhole, shoulder, neckline.
/// Corners: hem-centre, hem-side, waist-side, dart-lower, dart-tip, dart-upper (without a dart: side-high), underarm,
/// shoulder-tip, neck-side; the end is neck-centre.
struct UpperBlock {
    std::vector<Stroke> front, back;
    UpperLevels levels;
};

/// Error: a measure that no value settles.
[[nodiscard]] Result<UpperBlock> draftUpperBlock(const body::Measurements& measurements, const Figures& figures,
                                                 const UpperBlockSettings& settings);

/// The half as a piece of its own, closed along the centre.
[[nodiscard]] pattern::Contour halfContour(const std::string& piece, std::vector<Stroke> half);

} // namespace toile::samples
