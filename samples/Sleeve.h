// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "samples/Strokes.h"

namespace toile::samples {

/// The armholes a sleeve is drafted for: each with its length and the length from the underarm to its notch [m].
struct Armholes {
    double front = 0, back = 0;
    double frontNotch = 0, backNotch = 0;
};

struct SleeveSettings {
    double width = 0.34;          ///< at the biceps [m]
    double bicepsBelow = 0;       ///< where the biceps is measured, beneath the cap's base [m]
    double bottom = 0.22;         ///< length of the bottom edge [m]
    double underarmLength = 0.42; ///< the sleeve seam [m]
    double frontEase = 0.005;     ///< cap longer than the armhole, all of it above the notch [m]
    double backEase = 0.007;
};

/// The left sleeve seen from its right side: cap up, y = 0 at the cap's base, x = 0 on its middle, the back on +x.
/// Edges: bottom, seam-back, cap-back, cap-front, seam-front; corners: bottom-front, bottom-back, underarm-back,
/// cap-top, underarm-front.
struct Sleeve {
    std::vector<Stroke> strokes;
    double frontNotch = 0, backNotch = 0; ///< fractions of the cap edges' arc lengths
    double capHeight = 0, bottomY = 0;    ///< [m]
    double capWidth = 0;                  ///< at its base [m]
};

/// Error: a measure that no value settles.
[[nodiscard]] Result<Sleeve> draftSleeve(const Armholes& armholes, const SleeveSettings& settings);

} // namespace toile::samples
