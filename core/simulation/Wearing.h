// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Sew.h"

namespace toile::simulation {

/// What became of a garment while its body moved, and after it stood still again.
struct WearingReport {
    double seconds = 0;     ///< of the motion [s]
    int steps = 0;          ///< frame steps of it
    double bodySpeed = 0;   ///< largest [m/s]
    ContactSummary contact; ///< the worst of all these steps; its guarantee is that of before, as plans made anew on
                            ///< the way have not looked yet
    double offItsPin = 0;   ///< the farthest that cloth pinned to the body was from where that had carried its place,
                            ///< at the end of a step: held back by other cloth [m]
    double hemRise = 0;     ///< of the garment's lowest point, from before the motion to rest after it [m]
    double cpuSeconds = 0;  ///< of the motion
    SewReport after;        ///< at rest again; not judged as worn: the body's landmarks have not moved with it

    /// At rest, outside the body all the way, and as free of crossings with itself as before.
    [[nodiscard]] bool reachedItsGoal() const;
};

/// Moves the body of a garment that is worn, then goes on to rest and equilibrium as sew() does. Errors: as moveBody(),
/// cancelled, or a number that is no longer finite.
[[nodiscard]] Result<WearingReport> wear(Simulation& simulation, std::shared_ptr<const geometry::VertexMotion> motion,
                                         const SewSettings& settings, std::stop_token stop = {},
                                         const Progress& progress = {}, const FrameObserver& observer = {});

/// docs/formats/sew.md, under "motion".
[[nodiscard]] Json toJson(const WearingReport& report);

} // namespace toile::simulation
