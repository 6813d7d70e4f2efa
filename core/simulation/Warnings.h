// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Inspect.h"

#include <vector>

namespace toile::simulation {

/// What the user should know of a garment as it lies: seams and tacks that are open, layers and cells that pass through
/// each other or the body, steps and substeps that were not what they should be.
[[nodiscard]] std::vector<Warning> warningsOf(const Simulation& simulation, const ContactSummary& contact);

} // namespace toile::simulation
