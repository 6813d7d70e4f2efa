// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/collision/BodySurface.h"

namespace toile::collision {

/// Where a point on its straight way first comes as near to the body as the given distance [m]: the surface there.
/// None if it does not, or if it starts inside. No speed is too high and no limb too thin: each step is no longer than
/// the way that is certainly free. Ref: Mirtich 1996, conservative advancement.
[[nodiscard]] std::optional<SurfacePoint> firstTouch(const BodySurface& body, const Vec3& from, const Vec3& to,
                                                     double distance);

} // namespace toile::collision
