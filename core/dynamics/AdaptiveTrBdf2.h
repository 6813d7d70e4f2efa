// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/ImplicitRungeKutta.h"

namespace toile::dynamics {

struct AdaptiveSettings {
    ImplicitSettings implicit;
    double tolerance = 1e-4;    ///< of the estimated error of a part's positions, root mean square by mass [m]
    double smallestStep = 1e-6; ///< a part so short is taken whatever its error, with a flag [s]
};

/// TR-BDF2 that divides a step so that the difference to its companion of third order stays below a
/// tolerance.
///
/// The difference is filtered by the matrix of the stages, (H + cM)⁻¹cM, so that stiff waves, which the
/// method damps and the estimate would not, do not dictate the step. A part that is too coarse, or that
/// Newton does not solve, is made again, shorter. The length of the parts is remembered from step to step.
/// Ref: Hosea, Shampine 1996
class AdaptiveTrBdf2 final : public ImplicitRungeKutta {
public:
    explicit AdaptiveTrBdf2(const cloth::ClothModel& model, AdaptiveSettings settings = {})
        : ImplicitRungeKutta(model, trBdf2(), settings.implicit), settings_(settings) {}

protected:
    [[nodiscard]] Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                             std::span<Stage* const> stages, std::stop_token stop) override;

private:
    /// Over the tolerance [–].
    [[nodiscard]] double errorOf(const std::vector<Vec3>& difference, double h);

    AdaptiveSettings settings_;
    double wanted_ = 0; ///< length of the next part [s]; 0 = as long as the step
};

} // namespace toile::dynamics
