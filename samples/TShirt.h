// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/UpperBlock.h"

#include "core/document/Document.h"

namespace toile::samples {

/// A T-shirt of jersey with short sleeves and a neckband of rib. Lengths [m].
struct TShirtSettings {
    double spacing = 0.02; ///< ε_m of every piece but the band, which has half
    UpperBlockSettings block{.bustEase = 0.06,
                             .hipEase = 0.04,
                             .acrossBackEase = 0.015,
                             .acrossFrontEase = 0.045,
                             .neckGap = 0.018,
                             .napeGap = 0.012,
                             .waistSuppression = 0.010,
                             .armholeDepth = 0.205,
                             .dartIntake = 0};
    double bicepsEase = 0.10;
    double sleeveLength = 0.12; ///< of its seam
    double sleeveBottom = 0.34; ///< of its hem
    double frontCapEase = 0.001, backCapEase = 0.002;
    double bandWidth = 0.020;
    double bandRatio = 0.85; ///< length of the band / length of the neckline [–]
};

/// Pieces: front, back, sleeve-left, sleeve-right, neckband.
/// Error: a measure that no value settles.
[[nodiscard]] Result<document::Document> tShirt(const body::Measurements& measurements, const body::Body& body,
                                                const TShirtSettings& settings = {});

} // namespace toile::samples
