// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Minimiser.h"

namespace toile::dynamics {

/// Backward Euler with full Newton: minimises ½|x − (x₀ + h·v₀)|²_M/h² + E(x) − Σ m g·x. Stable at every step, damps what
/// it cannot resolve by 1/√(1 + ω²h²) a step; first order. The baseline of comparisons.
class ImplicitEuler {
public:
    ImplicitEuler(const cloth::ClothModel& model, MinimiserSettings settings = {}) : minimiser_(model, settings) {}

    /// The report says whether the step was solved; the state is then the best found.
    [[nodiscard]] Result<MinimiserReport> step(ParticleState& state, double duration, const Vec3& gravity,
                                               std::span<Stage* const> stages = {}, std::stop_token stop = {});

private:
    Minimiser minimiser_;
    std::vector<Vec3> start_, target_;
};

} // namespace toile::dynamics
