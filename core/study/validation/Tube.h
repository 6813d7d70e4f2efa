// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Stage.h"
#include "core/simulation/Garment.h"
#include "core/study/validation/Findings.h"

#include <optional>

namespace toile::study::validation {

/// A rectangle whose two upright sides are sewn together, as the simulation makes it: merged, with hinges along the
/// seam.
struct Tube {
    simulation::Garment garment;
    double round = 0, height = 0;  ///< of the rectangle [m]
    std::vector<Vec2> material;    ///< of each particle: u round, v up [m]
    dynamics::ParticleState state; ///< a round tube about the y axis, without stretch

    [[nodiscard]] double radius() const; ///< at rest [m]
};

/// Absent, with the reason in `found`, if it cannot be made.
[[nodiscard]] std::optional<Tube> tubeOf(Findings& found, const material::Fabric& fabric, double round, double height,
                                         double spacing);

} // namespace toile::study::validation
