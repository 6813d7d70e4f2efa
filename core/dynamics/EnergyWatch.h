// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/EnergyTurnover.h"
#include "core/dynamics/Stage.h"

namespace toile::dynamics {

/// Sees position-based steps gain energy that nothing gave them: no hand, no seam, no air, no body that moves.
///
/// How much softened cloth stores is not known. But speed and height can only gain what it lets go of, and that is at
/// most what the true stiffness says. docs/physics/xpbd.md
class EnergyWatch {
public:
    /// The model is borrowed and outlives the watch. allowed: of the energy turned over so far [–].
    EnergyWatch(const cloth::ClothModel& model, const Vec3& gravity, double allowed = 0.01);

    /// Whether a step from one state to the other gained energy.
    [[nodiscard]] bool gains(const ParticleState& before, const ParticleState& after);

private:
    const cloth::ClothModel& model_;
    Vec3 gravity_;
    double allowed_;
    EnergyTurnover turnover_;
};

} // namespace toile::dynamics
