// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/ImplicitRungeKutta.h"

namespace toile::dynamics {

/// BDF2 with steps of any ratio: second order, L-stable, one solve a step. It leans on the step before; a
/// step that does not go on where its last one ended, or that could not be solved, is made by TR-BDF2.
class Bdf2 final : public ImplicitRungeKutta {
public:
    explicit Bdf2(const cloth::ClothModel& model, ImplicitSettings settings = {})
        : ImplicitRungeKutta(model, trBdf2(), settings) {}

    [[nodiscard]] std::string_view name() const override { return "bdf2"; }
    [[nodiscard]] std::size_t bytes() const override;

protected:
    [[nodiscard]] Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                             std::span<Stage* const> stages, std::stop_token stop) override;

private:
    ParticleState before_, last_; ///< of the last step: its start and its end
    double lastDuration_ = 0;     ///< [s]; 0 = there was none
};

} // namespace toile::dynamics
