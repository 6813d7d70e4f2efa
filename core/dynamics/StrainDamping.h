// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/StrainGradients.h"
#include "core/dynamics/Stage.h"

#include <vector>

namespace toile::dynamics {

/// Stiffness-proportional damping: every strain s of the cloth with stiffness k is resisted by β·k·ṡ, as by a dashpot
/// beside its spring (Kelvin–Voigt). β [s] is the time in which a strain that is let go without inertia falls to 1/e;
/// of an oscillation with ω it takes the part βω/2 of critical damping. Cloth that moves as a rigid body is not
/// resisted, momentum is kept, and no energy is put in. docs/dynamics.md
class StrainDamping final : public Stage {
public:
    /// time: β. The model is borrowed; positions: about which the cloth will be.
    StrainDamping(const cloth::ClothModel& model, double time, std::span<const Vec3> positions);

    [[nodiscard]] std::string_view name() const override { return "strain damping"; }
    [[nodiscard]] std::size_t bytes() const override { return strains_.capacity() * sizeof(cloth::StrainGradient); }
    void beginStep(const ParticleState&, double) override { motion_ = {}; }
    /// Dashpot by dashpot: R → R/(1 + h·β·k·w) for the way R of a strain that is foreseen. What is foreseen is damped,
    /// and not what the sweep makes of it: the sweep then begins with less kinetic energy, however strong they are.
    void project(Substep& substep) override;
    [[nodiscard]] bool isBeforeSweep() const override { return true; }

    [[nodiscard]] bool isDissipative() const override { return true; }
    void take(const Motion& motion) override { motion_ = motion; }
    /// Gradients are those of these positions; in statics nothing moves, and there are none.
    void fixFriction(std::span<const Vec3> positions) override;
    void beginIteration(std::span<const Vec3>) override {}
    /// Half of what the dashpots take in the time of the motion, if that is from somewhere; else 0.
    [[nodiscard]] double energy(std::span<const Vec3> positions) const override;
    void addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const override;
    void addHessian(std::span<const Vec3> positions, HessianSink& sink) const override;
    /// Explicit steps are as short as for an oscillation with ω·(√(1 + ζ²) + ζ), ζ = βω/2, ω the cloth's largest.
    [[nodiscard]] double largestFrequencySquared() const override { return frequencySquared_; }

private:
    [[nodiscard]] double rateOf(const cloth::StrainGradient& strain, std::span<const Vec3> positions) const;

    const cloth::ClothModel& model_;
    double time_;             ///< β [s]
    double frequencySquared_; ///< [1/s²]
    Motion motion_;
    std::vector<cloth::StrainGradient> strains_;
};

} // namespace toile::dynamics
