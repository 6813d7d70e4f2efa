// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/XpbdIntegrator.h"

namespace toile::dynamics {

XpbdIntegrator::XpbdIntegrator(const cloth::ClothModel& model, XpbdSettings settings, int substeps)
    : Integrator(model), xpbd_(model, settings), substeps_(substeps),
      longestLine_(substeps > 0 ? 0 : springsOnLongestLine(model)) {}

Result<StepReport> XpbdIntegrator::advance(ParticleState& state, double duration, const Vec3& gravity,
                                           std::span<Stage* const> stages, std::stop_token stop) {
    const int substeps = substeps_ > 0 ? substeps_ : substepsFor(duration, longestLine_, length(gravity));
    if (auto done = xpbd_.step(state, duration, substeps, gravity, stages, stop); !done)
        return tl::unexpected(done.error());
    return StepReport{.parts = substeps};
}

} // namespace toile::dynamics
