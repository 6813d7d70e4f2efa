// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/ImplicitStage.h"

#include <array>

namespace toile::dynamics {

/// Coefficients of a diagonally implicit Runge–Kutta method: k_i = f(x₀ + h·Σ_{j≤i} a_ij k_j), x₁ = x₀ + h·Σ
/// b_i k_i. All implicit stages have the same a_ii, so that one matrix serves them; a first stage with a_00 =
/// 0 is explicit.
struct ButcherTableau {
    static constexpr int mostStages = 5;
    std::string_view name;
    int stages = 1;
    std::array<std::array<double, mostStages>, mostStages> a{};
    std::array<double, mostStages> b{};
    /// b − b̂ of a companion of other order, whose step differs by h·Σ d_i k_i; all 0 where there is none.
    std::array<double, mostStages> difference{};
    /// A part that gains energy is made again by backward Euler: what is stiff and far from balance, or meets a body
    /// within the part, an explicit first stage throws back faster than it came.
    bool guarded = false;
};

[[nodiscard]] const ButcherTableau& backwardEuler(); ///< first order, damps what it cannot resolve by 1/√(1 + ω²h²)
[[nodiscard]] const ButcherTableau& implicitMidpoint(); ///< second order, keeps energy, does not damp stiff modes
/// Trapezoid over γh, γ = 2 − √2, then BDF2: second order, L-stable; companion of third order. Ref: Bank et
/// al. 1985; Hosea, Shampine 1996
[[nodiscard]] const ButcherTableau& trBdf2();
[[nodiscard]] const ButcherTableau& sdirk4(); ///< five stages, fourth order, L-stable. Ref: Hairer, Wanner 1996, IV.6

/// All the implicit one-step methods. A step whose stages are not solved is halved, and at last taken with a
/// flag.
class ImplicitRungeKutta : public Integrator {
public:
    ImplicitRungeKutta(const cloth::ClothModel& model, const ButcherTableau& tableau, ImplicitSettings settings = {});

    [[nodiscard]] std::string_view name() const override { return tableau_.name; }
    [[nodiscard]] std::size_t bytes() const override { return stage_.bytes(); }

protected:
    struct Step {
        StepReport report;
        std::vector<Vec3> difference; ///< of the position from the companion's [m]; empty without companion
        bool gains = false;           ///< energy that no one put in; only looked at if guarded
    };
    /// One step as it is, solved or not.
    [[nodiscard]] Result<Step> once(ParticleState& state, double h, const Vec3& gravity, std::span<Stage* const> stages,
                                    std::stop_token stop) {
        return once(tableau_, state, h, gravity, stages, stop);
    }
    [[nodiscard]] Result<StepReport> advance(ParticleState& state, double duration, const Vec3& gravity,
                                             std::span<Stage* const> stages, std::stop_token stop) override;

    [[nodiscard]] ImplicitStage& stage() { return stage_; }
    [[nodiscard]] const ImplicitSettings& settings() const { return settings_; }

private:
    [[nodiscard]] Result<Step> once(const ButcherTableau& tableau, ParticleState& state, double h, const Vec3& gravity,
                                    std::span<Stage* const> stages, std::stop_token stop);

    const ButcherTableau& tableau_;
    ImplicitSettings settings_;
    ImplicitStage stage_;
};

} // namespace toile::dynamics
