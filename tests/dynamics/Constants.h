// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

/// What most tests of the room step with.
namespace toile {

inline constexpr Vec3 gravity{0, -9.81, 0}; ///< [m/s²]
inline constexpr double frame = 1.0 / 60;   ///< [s]

} // namespace toile
