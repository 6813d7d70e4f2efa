// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/MannequinShape.h"

namespace toile::body {

/// The woman that the tables of parts draw, with the default measurements; everything else is scaled from her.
inline constexpr Measurements drawn;

/// How much larger than the drawn woman each part is [–].
struct Scales {
    double tall = 1, ribs = 1, chest = 1, waist = 1, hip = 1, thigh = 1, neck = 1, biceps = 1, wrist = 1;
};

[[nodiscard]] Scales scalesOf(const Measurements& measurements, const ShapeFactors& factors);

// The tubes of the left half; frames and places along the arm as in MannequinShape. Lengths [m].
[[nodiscard]] SectionTube torsoOf(const Levels& levels, const Scales& scales);
[[nodiscard]] SectionTube shoulderOf(const Measurements& measurements, const Levels& levels, double rise, double z);
[[nodiscard]] SectionTube neckOf(const Transform& frame, const Scales& scales);
[[nodiscard]] SectionTube headOf(const Levels& levels, double tall);
[[nodiscard]] SectionTube armOf(const Transform& frame, const Scales& scales, double bicepsAt, double wristAt);
[[nodiscard]] SectionTube thumbOf(const Transform& arm, double wristAt, const Scales& scales);
[[nodiscard]] SectionTube legOf(const Levels& levels, const Scales& scales, double ankleX);
[[nodiscard]] SectionTube footOf(double ankleX, double tall);
/// x of the ankle's centre.
[[nodiscard]] double ankleXOf(const Scales& scales);

} // namespace toile::body
