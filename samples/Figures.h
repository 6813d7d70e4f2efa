// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/body/Mannequin.h"

namespace toile::samples {

/// What a pattern maker writes down before drafting a garment for the upper body: body measurements without any ease.
/// Heights count downward from the side neck point, along the cloth. [m], [rad]
struct Figures {
    double neckHalfWidth = 0;    ///< centre to side neck point
    double backNeckDepth = 0;    ///< side neck point down to the nape
    double frontNeckDepth = 0;   ///< side neck point down to the pit of the neck
    double shoulderLength = 0;   ///< side neck point to shoulder point
    double shoulderSlope = 0;    ///< below the horizontal
    double acrossBack = 0;       ///< between the folds of the arms, behind
    double acrossFront = 0;      ///< and before
    double backWaist = 0;        ///< side neck point to waist, over the shoulder blade
    double frontWaist = 0;       ///< side neck point over the bust point to the waist
    double bustHeight = 0;       ///< side neck point to bust point
    double bustHalfDistance = 0; ///< centre to bust point
    double waistToHip = 0;
};

/// From tape and landmarks, all lengths between landmarks straight; docs/samples.md has the sketch.
[[nodiscard]] Figures figuresOf(const body::Measurements& measurements, const body::Landmarks& landmarks);

} // namespace toile::samples
