// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Mannequin.h"
#include "core/document/Document.h"

namespace toile::samples {

/// A full circle skirt of two halves with seams before and behind, on a waistband.
struct CircleSkirtSettings {
    double spacing = 0.025;        ///< ε_m [m]
    double waistEase = 0.01;       ///< of waistband and waist edge [m]
    double length = 0.50;          ///< waist edge to hem [m]
    double waistbandWidth = 0.035; ///< [m]
};

/// Pieces: skirt-left, skirt-right, waistband. The waist edge is a circle of radius (waist + ease) / 2π.
[[nodiscard]] document::Document circleSkirt(const body::Measurements& measurements, const body::Body& body,
                                             const CircleSkirtSettings& settings = {});

} // namespace toile::samples
