// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Simulation.h"

#include <span>
#include <vector>

namespace toile::simulation {

/// Whether nothing but its waistband keeps the garment up.
[[nodiscard]] bool hangsOnItsWaistband(const Simulation& simulation);

/// The nodes of a finer garment that lie where its uppermost cloth lay on a coarser mesh: 40 mm of it, measured from
/// the rim. Empty for a garment that has shoulders to hang on, for a cloth whose only rim is its hem, and without a
/// body.
[[nodiscard]] std::vector<int> nodesItHangsBy(const Simulation& coarse, const Simulation& fine);

/// Whether a sewn garment beside a body with limbs has no legs: what is below its waistband hangs round the body in
/// folds that nothing spreads.
[[nodiscard]] bool hangsInFreeFolds(const Simulation& simulation);

/// Mass scaling: how many times its mass each particle's inertia has to be, at least 1, for position-based substeps of
/// length h [s] not to cap the lengthwise and crosswise stiffness of cloth at these nodes. Dimensionless, by particle.
/// Ref: Olovsson, Simonsson, Unosson 2005 – docs/physics/xpbd.md
[[nodiscard]] std::vector<double> inertiaOf(const Garment& garment, std::span<const int> nodes, double h);

} // namespace toile::simulation
