// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Integrator.h"
#include "core/dynamics/TotalEnergyWatch.h"

#include <functional>

namespace toile::dynamics {

/// What a step is made with.
struct Guarded {
    Integrator& method;
    std::function<Integrator&()>
        safe;                ///< damps what it cannot resolve; asked for at a step that the method cannot make
    TotalEnergyWatch* watch; ///< null: something drives the cloth
};

struct GuardedReport {
    StepReport step; ///< accurate is false also where energy was gained to the last
    bool redone = false;
};

/// A step that gained energy, or did not end in numbers, is made again by the safe method, whole, in two parts and in
/// four; then it is taken as it is, if it can be.
[[nodiscard]] Result<GuardedReport> guardedStep(const Guarded& by, ParticleState& state, double duration,
                                                const Vec3& gravity, std::span<Stage* const> stages,
                                                std::stop_token stop = {});

} // namespace toile::dynamics
