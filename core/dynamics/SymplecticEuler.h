// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/FrequencyBound.h"
#include "core/dynamics/Integrator.h"

namespace toile::dynamics {

struct SymplecticEulerSettings {
    double damping = 0;            ///< mass-proportional [1/s]
    bool automaticSubsteps = true; ///< divide a step that is too long; otherwise refuse it
    double safety = 0.9;           ///< of the limit 2/ω_max that automatic substeps use [–]
};

/// v += h·a(x); x += h·v. Explicit: stable only for steps below stepLimit(). First order, keeps energy.
class SymplecticEuler final : public Integrator {
public:
    explicit SymplecticEuler(const cloth::ClothModel& model, SymplecticEulerSettings settings = {})
        : Integrator(model), settings_(settings), frequency_(model) {}

    [[nodiscard]] std::string_view name() const override { return "symplectic-euler"; }
    [[nodiscard]] std::size_t bytes() const override { return accelerations_.capacity() * sizeof(Vec3); }
    /// 2/ω_max by Gershgorin's bound; positions: where hinges are bounded, not needed without hinges.
    [[nodiscard]] double stepLimit(std::span<const Vec3> positions = {},
                                   std::span<Stage* const> stages = {}) const override;

protected:
    [[nodiscard]] Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                             std::span<Stage* const> stages, std::stop_token stop) override;

private:
    SymplecticEulerSettings settings_;
    FrequencyBound frequency_;
    std::vector<Vec3> accelerations_;
};

} // namespace toile::dynamics
