// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/batch/Commands.h"
#include "core/simulation/Sew.h"
#include "core/simulation/Wearing.h"

namespace toile::batch {

/// Prints what became of the garment, in a dozen lines; warnings on stderr.
void printSummary(const simulation::SewReport& report, const SewOptions& options);
/// Prints what it did while the avatar moved.
void printWearing(const simulation::WearingReport& wearing);

} // namespace toile::batch
