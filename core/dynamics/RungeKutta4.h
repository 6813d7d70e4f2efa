// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/FrequencyBound.h"
#include "core/dynamics/Integrator.h"

namespace toile::dynamics {

struct RungeKutta4Settings {
    double damping = 0;  ///< mass-proportional [1/s]
    double safety = 0.6; ///< of the limit 2√2/ω_max [–]: there its time error is far below every other error
};

/// The classical explicit method of fourth order; beyond its limit a step is divided. The reference where
/// affordable.
class RungeKutta4 final : public Integrator {
public:
    explicit RungeKutta4(const cloth::ClothModel& model, RungeKutta4Settings settings = {})
        : Integrator(model), settings_(settings), frequency_(model) {}

    [[nodiscard]] std::string_view name() const override { return "rk4"; }
    [[nodiscard]] std::size_t bytes() const override { return 12 * accelerations_.capacity() * sizeof(Vec3); }
    [[nodiscard]] double stepLimit(std::span<const Vec3> positions = {},
                                   std::span<Stage* const> stages = {}) const override;

protected:
    [[nodiscard]] Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                             std::span<Stage* const> stages, std::stop_token stop) override;

private:
    RungeKutta4Settings settings_;
    FrequencyBound frequency_;
    std::vector<Vec3> accelerations_;
};

} // namespace toile::dynamics
