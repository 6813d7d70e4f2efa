// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Integrator.h"
#include "core/dynamics/Xpbd.h"

namespace toile::dynamics {

/// Xpbd with a number of substeps that is given, or found from the mesh.
class XpbdIntegrator final : public Integrator {
public:
    /// substeps of a step; 0 = for a transport error of 2 mm.
    XpbdIntegrator(const cloth::ClothModel& model, XpbdSettings settings, int substeps);

    [[nodiscard]] std::string_view name() const override { return "xpbd"; }
    [[nodiscard]] std::size_t bytes() const override { return xpbd_.bytes(); }

protected:
    [[nodiscard]] Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                             std::span<Stage* const> stages, std::stop_token stop) override;

private:
    Xpbd xpbd_;
    int substeps_;
    int longestLine_;
};

} // namespace toile::dynamics
