// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Mannequin.h"
#include "core/document/Document.h"

namespace toile::samples {

/// A skirt of two rectangles gathered into a waistband.
struct GatheredSkirtSettings {
    double spacing = 0.025;        ///< ε_m [m]
    double waistEase = 0.01;       ///< of the waistband [m]
    double gatherRatio = 1.6;      ///< waist edge over waistband [–]
    double length = 0.50;          ///< waist edge to hem [m]
    double waistbandWidth = 0.035; ///< [m]
};

/// Pieces: skirt-front, skirt-back, waistband. Both panels are the same rectangle.
[[nodiscard]] document::Document gatheredSkirt(const body::Measurements& measurements, const body::Body& body,
                                               const GatheredSkirtSettings& settings = {});

} // namespace toile::samples
