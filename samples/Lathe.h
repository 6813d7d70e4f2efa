// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/TriangleMesh.h"
#include "core/geometry/Vec.h"

#include <vector>

namespace toile::samples {

/// The closed surface that a profile (radius, height) [m] sweeps round the y axis. The profile runs with the solid on
/// its left, from a first to a last point of radius 0.
[[nodiscard]] geometry::TriangleMesh lathed(const std::vector<Vec2>& profile, int around);

} // namespace toile::samples
