// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Result.h"
#include "core/cloth/ClothModel.h"
#include "core/dynamics/Eliminated.h"
#include "core/dynamics/Stage.h"

#include <cstddef>
#include <limits>
#include <span>
#include <stop_token>
#include <string_view>

namespace toile::dynamics {

/// What a step took.
struct StepReport {
    int parts = 1;                 ///< into which the step was divided
    int newtonIterations = 0;      ///< of implicit methods
    int factorizations = 0;        ///< direct ones
    int gradientIterations = 0;    ///< of conjugate gradients
    std::size_t refusedFactor = 0; ///< what a factor would have taken that did not fit in memory [B]; 0 = all did
    int repeated = 0;              ///< parts that failed and were made again, smaller or by a safer method
    bool accurate = true;          ///< false: a part at the smallest step missed its tolerance and was taken as it was
    double residual = 0;           ///< largest unsolved force of a part over the mean particle weight [–]
    double limit = std::numeric_limits<double>::infinity(); ///< of explicit methods, the longest stable part [s]

    StepReport& operator+=(const StepReport& more);
};

/// A way to move the particles of a cloth through time.
///
/// Whatever the method: pinned particles stay, slaves follow their masters, equal starts give equal bits, and
/// no number that is not finite goes in or out. The model is borrowed and constant; after a merge make a new
/// integrator. Velocities obey v̇ = M⁻¹F(x) − damping·v. docs/dynamics.md
class Integrator {
public:
    virtual ~Integrator() = default;

    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual std::size_t bytes() const = 0;
    /// The longest step that is stable undivided [s]; infinity for implicit and position-based methods.
    [[nodiscard]] virtual double stepLimit(std::span<const Vec3> positions = {},
                                           std::span<Stage* const> stages = {}) const;

    /// Advances by duration [s]. Errors, after which the state is as before: a duration that is not in (0,
    /// 1], a number that is not finite before or after, a particle without mass, cancelled.
    [[nodiscard]] Result<StepReport> step(ParticleState& state, double duration, const Vec3& gravity,
                                          std::span<Stage* const> stages = {}, std::stop_token stop = {});

protected:
    explicit Integrator(const cloth::ClothModel& model) : model_(model), eliminated_(model) {}
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    /// The state is sound, and duration as promised; time is kept by the caller.
    [[nodiscard]] virtual Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                                     std::span<Stage* const> stages, std::stop_token stop) = 0;

    /// M⁻¹(cloth + stages) + gravity of free particles, 0 for the others. Stages look at the state first; h: for which
    /// the accelerations are taken [s].
    void accelerationsAt(const ParticleState& state, double h, const Vec3& gravity, std::span<Stage* const> stages,
                         std::vector<Vec3>& accelerations);
    /// Lets stages shorten the ways of a part that took h [s], from where particles were to where the state has them.
    /// What a way loses its velocity does, too.
    void hold(std::span<const Vec3> from, ParticleState& state, double h, std::span<Stage* const> stages) const;
    [[nodiscard]] const cloth::ClothModel& model() const { return model_; }
    [[nodiscard]] const Eliminated& eliminated() const { return eliminated_; }

private:
    const cloth::ClothModel& model_;
    Eliminated eliminated_;
    std::vector<Vec3> forces_;
};

} // namespace toile::dynamics
