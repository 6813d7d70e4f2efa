// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Simulation.h"

#include <optional>
#include <vector>

namespace toile::study {

/// Where points of every piece lie in a drape; nothing where the mesh does not hold the point.
using DrapedLattice = std::vector<std::optional<Vec3>>;

/// At 33 × 33 material points of every piece, in the middles of as many equal boxes of its extent: the same points
/// whatever the mesh.
[[nodiscard]] DrapedLattice latticeOf(const simulation::Simulation& simulation);

struct LatticeDifference {
    double rms = 0, maximum = 0; ///< [m]
    int points = 0;              ///< that both hold
};
[[nodiscard]] LatticeDifference differenceOf(const DrapedLattice& a, const DrapedLattice& b);

} // namespace toile::study
