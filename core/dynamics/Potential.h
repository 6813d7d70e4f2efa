// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Forces.h"
#include "core/dynamics/BlockMatrix.h"
#include "core/dynamics/Eliminated.h"
#include "core/dynamics/Minimiser.h"

#include <span>
#include <vector>

namespace toile::dynamics {

/// Φ, what a run of the minimiser makes small: elastic energy of cloth and stages, gravity and inertia, as a function
/// of where particles are. Forces and Hessians are those of the unknowns that move them. What it is made of outlives
/// it.
class Potential {
public:
    Potential(const cloth::ClothModel& model, const Eliminated& eliminated, std::span<const double> mass,
              const MinimiserProblem& problem);

    struct Measured {
        double energy = 0;        ///< [J]
        std::vector<Vec3> forces; ///< of the unknowns [N]
        double largest = 0;       ///< force [N]
        int worst = -1;           ///< particle
    };

    [[nodiscard]] double energyAt(std::span<const Vec3> x) const; ///< [J]
    [[nodiscard]] Measured measuredAt(std::span<const Vec3> x) const;
    /// The second derivative without inertia.
    void assemble(std::span<const Vec3> x, cloth::HessianForm form, BlockMatrix& into) const;
    /// Moves the unknowns to a fraction of the step, and what follows them.
    void moveTo(std::span<Vec3> x, std::span<const Vec3> from, std::span<const Vec3> step, double fraction) const;

    [[nodiscard]] double forceScale() const; ///< mean particle weight, to which residuals are relative [N]
    /// Residual that rounding leaves [–].
    [[nodiscard]] double roundingFloor(std::span<const Vec3> x) const;
    [[nodiscard]] std::span<const double> mass() const { return mass_; } ///< of the unknowns [kg]
    [[nodiscard]] double inertia() const { return inertia_; }            ///< [1/s²]
    [[nodiscard]] std::span<Stage* const> stages() const { return stages_; }
    [[nodiscard]] Team* team() const { return team_; } ///< null = alone

private:
    const cloth::ClothModel& model_;
    const Eliminated& eliminated_;
    std::span<const double> mass_;
    Vec3 gravity_;
    std::span<Stage* const> stages_;
    double inertia_;
    std::span<const Vec3> target_;
    Team* team_;
};

} // namespace toile::dynamics
