// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <span>

namespace toile::simulation {

/// How fast cloth moved in a frame step.
struct Speeds {
    double largest = 0; ///< of a particle [m/s]
    double mean = 0;    ///< of the cloth: root of the mean square, by mass [m/s]

    /// No particle moves, or the cloth as a whole lies still while a few of its particles tremble, as position-based
    /// steps may let them for ever where cloth is crumpled.
    [[nodiscard]] bool areOfRest() const { return largest < 0.005 || mean < 0.0002; }
    /// It has found its place and hardly moves on.
    [[nodiscard]] bool areCalm() const { return mean < 0.005; }
    /// Not even that: in ten seconds no particle would go a millimetre, or the cloth a fifth of it.
    [[nodiscard]] bool areStill() const { return largest < 0.0001 || mean < 0.00002; }
};

/// mass: of each particle [kg]; duration: of the frame step [s].
[[nodiscard]] Speeds speedsOf(std::span<const double> mass, std::span<const Vec3> before, std::span<const Vec3> after,
                              double duration);

} // namespace toile::simulation
