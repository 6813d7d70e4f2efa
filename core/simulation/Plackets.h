// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <span>
#include <vector>

namespace toile::simulation {

/// The two ends of a tack on the sewn cloth.
struct HeldTogether {
    std::array<int, 2> piece;
    std::array<Vec3, 2> place; ///< [m]
};

/// Triangles, of the cloth's own particles, that fill the slits between neighbouring tacks where these hold two edges
/// of the cloth together: a shirt whose front is buttoned has a neckline and a hem like one that is sewn shut. They go
/// on from the cloth with the same side out. A tack counts where each of its ends is within 40 mm of the border of its
/// own piece, and both come to one border; one alone fills nothing.
/// triangles: particles; piece: of each triangle.
[[nodiscard]] std::vector<std::array<int, 3>> placketsOf(std::span<const std::array<int, 3>> triangles,
                                                         std::span<const int> piece, std::span<const Vec3> positions,
                                                         std::span<const HeldTogether> tacks);

} // namespace toile::simulation
