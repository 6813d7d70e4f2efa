// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/dynamics/Eliminated.h"
#include "core/dynamics/SweepKernels.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace toile::dynamics {

/// The elements of a cloth compiled for one substep length: flat arrays in the order of the sweep, neighbours in an
/// array share no particle, so that the processor need not wait for one before the next.
class XpbdSweep {
public:
    /// h substep [s], cap κ of XpbdSettings.
    XpbdSweep(const cloth::ClothModel& model, const Eliminated& eliminated, std::span<const double> inverseMass,
              double h, double cap);

    /// One Gauss–Seidel pass over all elements. Slaves are read through their masters and not written.
    void apply(std::span<Vec3> positions);
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Spring { // of two particles that are no slaves
        int a, b;
        double restLength;
        double correctionA, correctionB; ///< w/(w_a + w_b + compliance)
    };
    struct Term {
        int particle;
        double coefficient, correction;
    };
    struct Expanded { // a spring or stencil that touches slaves, written over their masters
        int begin, end;
        double restLength;
    };

    void compileSprings();
    [[nodiscard]] std::vector<FourSprings> inFours(const std::vector<std::vector<int>>& groups,
                                                   const std::vector<Spring>& springs) const;
    void compileStencils(const std::vector<cloth::Stencil>& stencils);
    void compileExpanded(std::span<const int> particles, std::span<const double> coefficients, double restLength,
                         double stiffness);
    [[nodiscard]] double compliance(double stiffness, double inverseMass) const;
    [[nodiscard]] bool touchesSlave(std::span<const int> particles) const;

    void applyExpanded(std::span<Place> x) const;
    void applyHinges(std::span<Place> x) const;
    void applyTriangles(std::span<Place> x) const;
    void applyCells(std::span<Place> x) const;
    [[nodiscard]] Vec3 placeOf(int particle, std::span<const Place> x) const;

    template <int Constraints>
    struct Mover;
    template <int Constraints>
    void solveMovers(std::span<Place> x, std::span<const Mover<Constraints>> movers,
                     const std::array<double, Constraints>& values,
                     const std::array<double, Constraints>& stiffness) const;
    template <int Constraints, int Corners>
    void solveBlock(std::span<Place> x, const std::array<int, Corners>& particles,
                    const std::array<double, Constraints>& values,
                    const std::array<std::array<Vec3, Corners>, Constraints>& gradients,
                    const std::array<double, Constraints>& stiffness) const;

    const cloth::ClothModel& model_;
    const Eliminated& eliminated_;
    std::span<const double> inverseMass_;
    double h_, cap_;
    std::vector<int> slaveOf_; ///< index into model.slaves; −1 = none
    const SweepKernels& kernels_ = fastestKernels();
    std::vector<Place> places_; ///< all particles, then some that no element moves
    std::vector<FourSprings> springs_;
    std::vector<Linear<3>> threePoint_;
    std::vector<Linear<4>> fourPoint_;
    std::vector<Expanded> expanded_;
    std::vector<Term> terms_;
    std::vector<int> triangleOrder_, cellOrder_;
};

} // namespace toile::dynamics
