// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Integrator.h"
#include "core/dynamics/Xpbd.h"

namespace toile::dynamics {

/// Xpbd::step. One whose end is no number is made again in twice as many substeps and without coarse levels, and once
/// more in twice as many; those that failed are counted as repeated. Errors are the step's, the last one's.
[[nodiscard]] Result<StepReport> stepOrFiner(Xpbd& xpbd, ParticleState& state, double duration, int substeps,
                                             const Vec3& gravity, std::span<Stage* const> stages,
                                             std::stop_token stop = {});

} // namespace toile::dynamics
