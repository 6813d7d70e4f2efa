// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Integrator.h"
#include "core/dynamics/Minimiser.h"

namespace toile::dynamics {

struct ImplicitSettings {
    double damping = 0;           ///< mass-proportional [1/s]
    double tolerance = 1e-4;      ///< largest unsolved force of a stage over the mean particle weight [–]
    int maximumIterations = 60;   ///< Newton iterations of a stage; then the step is halved
    int gradientIterations = 200; ///< of conjugate gradients in a solve, before the factor takes over; 0 = factor only
    std::optional<std::size_t> factorBytes = {}; ///< MinimiserSettings
    int halvings = 6; ///< of a step whose stages are not solved; after that it is accepted with a flag
};

/// The one equation of all implicit methods: find X with velocity V = (X − X*)/s where V = V* + s·(a(X) −
/// αV).
///
/// The minimum of ½c|x − y|²_M + E(x) − Σ m g·x with c = (1 + αs)/s² and y = X* + s·V*/(1 + αs).
class ImplicitStage {
public:
    ImplicitStage(const cloth::ClothModel& model, const ImplicitSettings& settings);

    struct Known {
        std::vector<Vec3> position, velocity; ///< X*, V*
        double span = 0;                      ///< s [s]
    };
    /// state: in, the start; out, X and V. The best of the start, X* + s·V and y is where Newton begins;
    /// beside stages the start is: contact must see the way. Adds to the report; not solved → report.accurate
    /// = false.
    [[nodiscard]] Result<void> solve(ParticleState& state, const Known& known, const Vec3& gravity,
                                     std::span<Stage* const> stages, std::stop_token stop, StepReport& report);
    /// One Newton iteration from the start with a full step: the linearised equation. Not solved → report.accurate =
    /// false.
    [[nodiscard]] Result<void> solveLinearised(ParticleState& state, const Known& known, const Vec3& gravity,
                                               std::span<Stage* const> stages, StepReport& report);
    /// What the last stage's cloth lets pass of a change of positions, for stages of that span [s].
    [[nodiscard]] std::vector<Vec3> resisted(std::span<const Vec3> change, double span);
    [[nodiscard]] std::size_t bytes() const;

private:
    [[nodiscard]] double inertiaOf(double span) const;
    [[nodiscard]] std::vector<Vec3> targetOf(const Known& known) const;
    void takeVelocities(ParticleState& state, const Known& known) const;

    const cloth::ClothModel& model_;
    double damping_;
    Minimiser minimiser_;
};

/// Makes a part of a step; what does not reach its tolerance is made again in two halves, until a part is
/// duration/2^halvings: that one is accepted as it is. attempt(state, h) → Result<StepReport>.
template <class Attempt>
[[nodiscard]] Result<StepReport> halvedUntilSolved(ParticleState& state, double duration, int halvings,
                                                   const Attempt& attempt) {
    const ParticleState start = state;
    auto whole = attempt(state, duration);
    if (!whole || whole->accurate || halvings == 0) return whole;
    state = start;
    auto sum = halvedUntilSolved(state, duration / 2, halvings - 1, attempt);
    if (!sum) return sum;
    const auto second = halvedUntilSolved(state, duration / 2, halvings - 1, attempt);
    if (!second) return second;
    *sum += *second;
    whole->accurate = true;
    whole->residual = 0;
    whole->parts = 0;
    whole->repeated += 1;
    return *sum += *whole;
}

} // namespace toile::dynamics
