// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Sew.h"

namespace toile::simulation {

/// A garment that was sewn coarsely, as it goes on finely.
struct Refined {
    Simulation fine;
    CoarseRun coarse;
};

/// What keeps the band that the fine garment hangs by as stiff as it is.
enum class StiffBand {
    byInertia,  ///< Simulation::hangBy(): in as many substeps as the mesh needs
    bySubsteps, ///< as many as the scene asks for
};

/// Sews a garment on a coarse mesh until it rests, holds it as sew() does, and carries its drape over to a finer mesh
/// of the same pattern: to sew and to fall into place is cheap there. The fine garment has to come to rest yet, and to
/// its equilibrium, which the coarse one is not brought to. Errors: as sew() and Simulation::continued().
[[nodiscard]] Result<Refined> refined(Simulation coarse, Scene scene, const MeshOverrides& fine,
                                      const SewSettings& settings, StiffBand stiff = StiffBand::byInertia,
                                      std::stop_token stop = {}, const Progress& progress = {});

/// What is left to do of the settings for the fine garment: what was held is not held again.
[[nodiscard]] SewSettings settingsAfter(const CoarseRun& coarse, SewSettings settings);
/// Counts what the coarse run took with the rest.
void count(const CoarseRun& coarse, SewReport& report);

} // namespace toile::simulation
