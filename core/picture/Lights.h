// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/picture/Camera.h"

namespace toile::picture {

/// Unit vectors towards the lights. The studio turns with the camera, so that every view is lit as well as
/// the front: the key light from the upper left, a weak fill from the right, a rim light from behind.
struct Lights {
    Vec3 key, fill, rim;
};
[[nodiscard]] Lights lightsOf(const Camera& camera);

/// Maps a sphere that holds all casters, as a light far away in a direction sees it, to the clip cube; what
/// lies behind the sphere, such as the floor, still has a depth.
[[nodiscard]] Matrix4 shadowMatrix(const Vec3& towardsLight, const Vec3& centre, double radius);

} // namespace toile::picture
