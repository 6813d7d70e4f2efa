// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/EnergyTurnover.h"
#include "core/dynamics/Stage.h"

#include <span>

namespace toile::dynamics {

/// Sees steps at the cloth's true stiffness gain energy that nothing gave them: of cloth that no hand, no seam, no air
/// and no body drives, speed, height, and what cloth and stages store can together only fall.
///
/// docs/physics/integrators.md
class TotalEnergyWatch {
public:
    /// The model is borrowed and outlives the watch. allowed: above the lowest so far, of the energy turned over [–].
    TotalEnergyWatch(const cloth::ClothModel& model, const Vec3& gravity, double allowed = 0.01);

    /// Before a step of this duration [s]. What the step before it gained counts from now on.
    void begin(const ParticleState& before, double duration, std::span<Stage* const> stages);
    /// Whether the cloth, were the step taken so, would have gained energy. Asked again after the step was made again.
    [[nodiscard]] bool gains(const ParticleState& after);

private:
    const cloth::ClothModel& model_;
    Vec3 gravity_;
    double allowed_;
    EnergyTurnover turnover_;
    double limit_ = 0;  ///< above the lowest so far [J]
    double gained_ = 0; ///< the same, before the step [J]
    double rise_ = 0;   ///< in the step [J]
    double start_ = 0;  ///< all energy before the step [J]
};

} // namespace toile::dynamics
