// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "WornScenes.h"
#include "samples/SmallScenes.h"

namespace toile::simulation {

/// A tube that fits tightly round a post with or without shoulders below its upper opening.
inline Scene tubeRoundPost(double shoulderHeight) {
    const document::Document tube = samples::tubeRoundCylinder();
    body::Body post{"post", samples::cylinderMesh(), {}, {{body::Limb::torso, {{0, 1, 0}, {0, -0.2, 0}}}}};
    post.landmarks.acromionLeft.y = post.landmarks.acromionRight.y = shoulderHeight;
    return {tube.pattern, Shared<body::Body>(post), tube.scene};
}

constexpr double farAbove = 2, farBelow = 0; // [m]

} // namespace toile::simulation
