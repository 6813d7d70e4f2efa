// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/simulation/Openings.h"

namespace toile::simulation {

/// How a neckline lies at the back of the neck.
struct BackNeck {
    double napeDistance = 0; ///< of the back-neck point [m]
    bool below = false;      ///< it lies below the nape
    double widerBy = 0;      ///< than the neck, on either side [m]: so much lower an even neckline lies all round
};

/// The back-neck point is where the neckline crosses the middle of the body behind. Where a band or a collar stands on
/// the neckline there are two: on its edge, as a T-shirt's band has it, and on the seam below it, as a shirt's collar
/// does; the one nearer to the nape counts. `piece`: of each triangle, empty = all of one.
[[nodiscard]] BackNeck backNeckOf(const Opening& rim, std::span<const std::array<int, 3>> triangles,
                                  std::span<const int> piece, std::span<const Vec3> positions,
                                  const body::Landmarks& marks);

} // namespace toile::simulation
