// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/CollarStand.h"
#include "samples/Cuff.h"
#include "samples/FoldedCollar.h"
#include "samples/UpperBlock.h"

#include "core/document/Document.h"

namespace toile::samples {

/// A shirt of poplin, buttoned right over left: two fronts with a bust dart and a button stand each, a back with a
/// double yoke, seven-eighths sleeves with cuffs, a collar folded over its stand. Collar, stand and cuffs are
/// interfaced. Lengths [m].
struct ShirtSettings {
    double spacing = 0.02; ///< ε_m of every piece but stand and collar
    UpperBlockSettings block{.bustEase = 0.12,
                             .hipEase = 0.10,
                             .neckGap = 0.006, // a buttoned collar that is wider slides off the middle
                             .waistSuppression = 0.010,
                             .armholeDepth = 0.21,
                             .backShortening = 0.006,
                             .hipFullness = 0.62,
                             .hemBelowHip = 0.04,
                             .dartIntake = 0.028};
    double buttonStand = 0.015; ///< beyond the centre front, on either side
    double yokeDepth = 0.085;   ///< below the back neck
    double buttonDiameter = 0.011;
    double firstButton = 0.06, lastButton = 0.10; ///< below the neckline, above the hem
    double bicepsEase = 0.06, bicepsBelow = 0.10; ///< the girth is taken where the blouse's is
    double frontCapEase = 0.004, backCapEase = 0.0045;
    double cuffEase = 0.11, aboveWrist = 0.13, cuffWidth = 0.05;
    CollarStandSettings stand;
    FoldedCollarSettings collar;
};

/// Pieces: front-left, front-right, back, yoke, sleeve-left, sleeve-right, cuff-left, cuff-right, stand-left,
/// stand-right, collar. Error: a measure that no value settles.
[[nodiscard]] Result<document::Document> shirt(const body::Measurements& measurements, const body::Body& body,
                                               const ShirtSettings& settings = {});

} // namespace toile::samples
