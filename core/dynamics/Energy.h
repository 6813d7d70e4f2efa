// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/dynamics/Stage.h"

#include <span>

namespace toile::dynamics {

/// Energies of a state [J]; gravity's zero is at the origin.
struct Energies {
    double kinetic = 0, gravity = 0, elastic = 0;
    [[nodiscard]] double total() const { return kinetic + gravity + elastic; }
};

/// Of speed and height alone.
[[nodiscard]] Energies energiesOfMotion(const cloth::ClothModel& model, const ParticleState& state,
                                        const Vec3& gravity);
[[nodiscard]] Energies energies(const cloth::ClothModel& model, const ParticleState& state, const Vec3& gravity);
/// Together with what stages that put no energy in hold now, as they stand in this step.
[[nodiscard]] Energies energies(const cloth::ClothModel& model, const ParticleState& state, const Vec3& gravity,
                                std::span<Stage* const> stages);

/// Σ m v [kg·m/s].
[[nodiscard]] Vec3 momentum(const cloth::ClothModel& model, const ParticleState& state);
/// Σ m x × v about the origin [kg·m²/s].
[[nodiscard]] Vec3 angularMomentum(const cloth::ClothModel& model, const ParticleState& state);

/// Warns when a run gains energy that no one put in.
class EnergyMonitor {
public:
    /// Relative to the largest energy turned over so far.
    explicit EnergyMonitor(double allowedGrowth = 0.01) : allowedGrowth_(allowedGrowth) {}

    /// Looks at the energy after a frame; work [J] is what prescribed motion and seams did since the last call.
    /// True when the total has risen above its start by more than the work done and what is allowed.
    bool observe(const Energies& now, double work = 0);

    [[nodiscard]] double growth() const { return growth_; } ///< largest excess so far [J]

private:
    double allowedGrowth_;
    bool started_ = false;
    Energies first_;
    double start_ = 0, work_ = 0, scale_ = 0, growth_ = 0;
};

} // namespace toile::dynamics
