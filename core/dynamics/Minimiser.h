// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Progress.h"
#include "core/base/Result.h"
#include "core/cloth/ClothModel.h"
#include "core/dynamics/Stage.h"

#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

namespace toile::dynamics {

struct MinimiserSettings {
    double tolerance = 1e-3; ///< largest force over mean particle weight [–]
    int maximumIterations = 300;
    int memory = 6;             ///< iterations whose worst energy a step may not exceed; 1 = always descend
    double maximumMove = 0.02;  ///< of any particle in one iteration [m]: as far as contact sees ahead.
                                ///< Implicit steps without stages go as far as they like
    int gradientIterations = 0; ///< of conjugate gradients at most, before the factor takes over; 0 = factor only.
                                ///< Of implicit steps: statics has its own rule
    std::optional<std::size_t> factorBytes = {}; ///< that a factor may take, else conjugate gradients go on alone [B];
                                                 ///< absent = what the machine can give
};

/// Φ(x) = ½c|x − y|²_M + E(x) − Σ m g·x plus the energies of the stages.
struct MinimiserProblem {
    Vec3 gravity;
    std::span<Stage* const> stages;
    double inertia = 0;           ///< c [1/s²]; 0: statics, y is not read
    std::span<const Vec3> target; ///< y, one per particle [m]
    Team* team = nullptr;         ///< to share work with, where it is much; null = alone. The bits are the same
};

/// One Newton iteration, for logs and tests.
struct MinimiserIteration {
    double energy = 0;      ///< Φ before it [J]
    double residual = 0;    ///< before it, over mean particle weight [–]
    double largestMove = 0; ///< [m]
    int cuts = 0;           ///< of the line search
    int gradientIterations = 0;
    bool indefinite = false; ///< the exact Hessian was found to be
};

struct MinimiserReport {
    bool converged = false;
    double residual = 0;      ///< at the end, over mean particle weight [–]
    double residualFloor = 0; ///< what rounding allows: 8·eps·(k_max + c·m_max)·L over mean particle weight [–]
    int worstParticle = -1;   ///< where the residual is largest
    int iterations = 0, factorizations = 0, analyses = 0;
    int gradientIterations = 0;    ///< of conjugate gradients
    std::size_t refusedFactor = 0; ///< what a factor would have taken that did not fit in memory [B]; 0 = all did
    std::vector<MinimiserIteration> log;
};

/// Minimises Φ over the free particles.
///
/// Newton: the exact Hessian first, the projected one where that is indefinite; Armijo line search; statics
/// is approached by Levenberg weights that fall while steps are good. Pinned particles and slaves are
/// eliminated. The core of statics and of all implicit steps. Ref: docs/physics/newton.md
class Minimiser {
public:
    Minimiser(const cloth::ClothModel& model, MinimiserSettings settings = {});
    Minimiser(Minimiser&&) noexcept;
    Minimiser& operator=(Minimiser&&) noexcept;
    ~Minimiser();

    /// positions: start and result. Errors: cancelled, a number that is not finite, a singular system, one
    /// too large to solve. Not reaching the tolerance is no error: see the report.
    [[nodiscard]] Result<MinimiserReport> minimise(std::span<Vec3> positions, const MinimiserProblem& problem,
                                                   std::stop_token stop = {}, const Progress& progress = {});
    /// One full Newton step with the projected Hessian, wherever it leads. Converged: its linear system was solved.
    [[nodiscard]] Result<MinimiserReport> iterateOnce(std::span<Vec3> positions, const MinimiserProblem& problem);
    /// Replaces positions by the others if Φ is lower there; pinned particles stay.
    void takeBetter(std::span<Vec3> positions, std::span<const Vec3> others, const MinimiserProblem& problem) const;
    /// (H + cM)⁻¹ cM d with the last Hessian of a minimisation: what is left of a change that the cloth
    /// resists. d itself when none was needed. Written to free particles; the others get 0.
    [[nodiscard]] std::vector<Vec3> resisted(std::span<const Vec3> change, double inertia);
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Data;
    std::unique_ptr<Data> data_;
};

} // namespace toile::dynamics
