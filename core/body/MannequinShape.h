// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/body/Mannequin.h"
#include "core/body/SectionTube.h"

namespace toile::body {

/// What the search for the asked girths and lengths turns. 1 and 0 give the shape as it is drawn in the
/// tables.
struct ShapeFactors {
    double breast = 1, ribs = 1, chest = 1, waist = 1, hip = 1, neck = 1, biceps = 1, wrist = 1,
           thigh = 1; ///< on sections [–]
    double acromionRise = 0, crotchRise = 0, bustRise = 0,
           wristShift = 0; ///< on levels, and along the arm [m]
};

/// Heights above the floor of the places where the body is measured [m].
struct Levels {
    double crown = 0, chin = 0, nape = 0, sideNeck = 0, frontNeck = 0, acromion = 0, bust = 0, underBust = 0, waist = 0,
           hip = 0, pelvis = 0, crotch = 0, thigh = 0, knee = 0, ankle = 0;
};

/// The levels that measurements ask for.
[[nodiscard]] Levels levelsOf(const Measurements& measurements);

struct Ellipsoid {
    Transform frame; ///< its axes and centre
    Vec3 radii;      ///< along those axes [m]
    [[nodiscard]] double distance(const Vec3& point) const;
};

/// The body as a field: a smooth union of section tubes and of ellipsoids for breasts and buttocks.
/// The parts are those of the left half; the right one is its mirror image.
struct MannequinShape {
    Levels levels;
    double shoulderZ = 0;             ///< z of the shoulder line [m]
    double wristAt = 0, bicepsAt = 0; ///< along the arm from the shoulder joint [m]
    double neckAt = 0;                ///< where the neck is measured, along the neck [m]
    Transform neckFrame;              ///< y up the neck; origin in the plane of nape and pit of the neck
    Transform armFrame;               ///< y along the arm, z forward, x to its underside; origin at the shoulder joint
    SectionTube torso, shoulder, neck, head, arm, thumb, leg, foot;
    Ellipsoid breast, buttock, nose;

    /// Negative inside, zero on the skin; near the skin about the distance [m].
    [[nodiscard]] double distance(const Vec3& point) const;
};

[[nodiscard]] MannequinShape mannequinShape(const Measurements& measurements, const ShapeFactors& factors);

} // namespace toile::body
