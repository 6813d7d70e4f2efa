// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/BlockSolver.h"
#include "core/dynamics/Potential.h"
#include "core/dynamics/TrustedStep.h"

#include <memory>
#include <optional>
#include <stop_token>

namespace toile::dynamics {

/// A step that was taken, and what it brought.
struct TakenStep {
    double energy = 0, gain = 0, expected = 0; ///< Φ after it, its fall, and that of the model [J]
    double norm = 0;                           ///< √(sᵀPs)
    bool bounded = false;                      ///< by the trusted length
    int cuts = 0;
};

/// How a run of the minimiser comes to its next step, and learns from the last. Once it is asked to stop, a step ends
/// after the solution under way, and is of no use.
class NewtonSteps {
public:
    virtual ~NewtonSteps() = default;
    /// tolerance: force that a solution may leave [N]. Absent: nothing holds the cloth.
    [[nodiscard]] virtual std::optional<TrustedStep> stepAt(std::span<const Vec3> x, std::span<const Vec3> forces,
                                                            double tolerance, MinimiserIteration& log) = 0;
    /// The step truly brought `gain` of what was expected; stages that looked again found so much more energy [J].
    virtual void judge(const TakenStep& last, double surprise, double gain) = 0;
    /// No point on the last step was better.
    virtual void trustLess() = 0;
};

/// By the exact Hessian where it, or in statics a small shift of it, is positive definite, else by the projected one;
/// one factor each iteration. For steps in time, and for statics of few particles.
class ShiftedSteps : public NewtonSteps {
public:
    ShiftedSteps(const Potential& potential, BlockSolver& solver, std::stop_token stop = {});

    std::optional<TrustedStep> stepAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                                      MinimiserIteration& log) override;
    void judge(const TakenStep& last, double surprise, double gain) override;
    void trustLess() override;

    using Solution = std::optional<std::vector<Vec3>>; ///< absent: not positive definite
    [[nodiscard]] Solution projectedAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance);

private:
    [[nodiscard]] Solution solved(std::span<const Vec3> forces, double tolerance);
    [[nodiscard]] Solution moveAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                                  MinimiserIteration& log);

    const Potential& potential_;
    BlockSolver& solver_;
    std::stop_token stop_;
    double levenberg_;      ///< scale of μ [1/s²]
    double shift_;          ///< Levenberg weight μ [1/s²]: factors H + (c + μ)·M
    int projectedLeft_ = 0; ///< iterations for which the exact Hessian is not tried again
    int projectedRun_ = 0;
};

/// Of many particles' statics: by the exact Hessian as far as it is trusted. It is only multiplied by; what is factored
/// is the projected one, seldom; where its factor is refused, shifted steps go on without.
class TrustedSteps : public NewtonSteps {
public:
    /// leastForce: below which no solution need bring the residual [N].
    TrustedSteps(const Potential& potential, BlockSolver& solver, double leastForce, std::stop_token stop);

    std::optional<TrustedStep> stepAt(std::span<const Vec3> x, std::span<const Vec3> forces, double tolerance,
                                      MinimiserIteration& log) override;
    void judge(const TakenStep& last, double surprise, double gain) override;
    void trustLess() override;

private:
    [[nodiscard]] bool factoredAt(std::span<const Vec3> x);

    const Potential& potential_;
    BlockSolver& solver_;
    double leastForce_;
    std::stop_token stop_;
    double radius_ = 0;                   ///< as far as a model is trusted, √(sᵀPs); 0 before the first step
    BlockMatrix exact_;                   ///< H, whose projected form the solver's factor is of
    RoundedFactor preconditioner_;        ///< that factor
    std::optional<ShiftedSteps> without_; ///< once it is refused
    int served_ = 0, gradients_ = 0;      ///< iterations of this factor, conjugate gradients of the last
    bool factored_ = false;
};

/// The one for this run.
[[nodiscard]] std::unique_ptr<NewtonSteps> stepsFor(const Potential& potential, BlockSolver& solver, double tolerance,
                                                    std::stop_token stop);

} // namespace toile::dynamics
