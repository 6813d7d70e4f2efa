// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/batch/Commands.h"
#include "app/batch/Opening.h"
#include "core/simulation/Refine.h"

namespace toile::batch {

/// A garment that can be sewn, and what was done for it already.
struct Begun {
    simulation::Simulation simulation;
    std::optional<simulation::CoarseRun> coarse; ///< with --refine
};

/// From the start, sewn on the document's own mesh, or from where another run has stopped; on the mesh and in the
/// substeps that the options ask for. A start that overlaps becomes a warning, or an error with --strict.
[[nodiscard]] Result<Begun> begun(const SewOptions& options, OpenedScene& opened,
                                  const simulation::SewSettings& settings, std::stop_token stop);

} // namespace toile::batch
