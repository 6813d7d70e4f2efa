// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/ImplicitStage.h"

namespace toile::dynamics {

/// Backward Euler linearised at the start of the step: one Newton iteration, one linear solve, never a second
/// look. Stable for springs, and far too slow on stiff cloth, whose turning the linearised constraints block;
/// the baseline of comparisons. Ref: Baraff, Witkin 1998
class BaraffWitkin final : public Integrator {
public:
    explicit BaraffWitkin(const cloth::ClothModel& model, ImplicitSettings settings = {})
        : Integrator(model), stage_(model, settings) {}

    [[nodiscard]] std::string_view name() const override { return "baraff-witkin"; }
    [[nodiscard]] std::size_t bytes() const override { return stage_.bytes(); }

protected:
    [[nodiscard]] Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                             std::span<Stage* const> stages, std::stop_token stop) override;

private:
    ImplicitStage stage_;
};

} // namespace toile::dynamics
