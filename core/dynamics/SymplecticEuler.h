// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/cloth/ClothModel.h"
#include "core/dynamics/Stage.h"

#include <span>
#include <vector>

namespace toile::dynamics {

struct SymplecticEulerSettings {
    double damping = 0;            ///< mass-proportional [1/s]
    bool automaticSubsteps = true; ///< divide a step that is too long; otherwise refuse it
    double safety = 0.9;           ///< of the limit 2/ω_max that automatic substeps use [–]
};

/// v += h·a(x); x += h·v. Explicit: stable only for steps below stepLimit().
class SymplecticEuler {
public:
    /// positions: where hinges are bounded; not needed without hinges. The model must outlive it.
    SymplecticEuler(const cloth::ClothModel& model, SymplecticEulerSettings settings = {},
                    std::span<const Vec3> positions = {});

    /// 2/ω_max by Gershgorin's bound [s]; infinity for a cloth without elements.
    [[nodiscard]] double stepLimit() const { return stepLimit_; }

    /// One step; the error of a refusal names the limit, that of a state that is not finite the particle.
    /// Stages act by their forces.
    [[nodiscard]] Result<void> step(ParticleState& state, double duration, const Vec3& gravity,
                                    std::span<Stage* const> stages = {});

private:
    [[nodiscard]] Result<void> substep(ParticleState& state, double h, const Vec3& gravity,
                                       std::span<Stage* const> stages);

    const cloth::ClothModel& model_;
    SymplecticEulerSettings settings_;
    double stepLimit_;
    std::vector<char> held_; ///< pinned or slave
    std::vector<Vec3> forces_;
};

} // namespace toile::dynamics
