// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/dynamics/Eliminated.h"
#include "core/dynamics/SweepElements.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace toile::dynamics {

[[nodiscard]] inline std::array<int, 4> cornersOf(const cloth::Hinge& hinge) {
    return {hinge.a, hinge.b, hinge.c, hinge.d};
}

/// The elements of a sweep that touch slaves, beside a joint of regions: they are written over the masters of their
/// corners. They are few, and take their turn one after the other.
class JointSweep {
public:
    /// Triangles, cells and hinges are found; springs and stencils are added.
    JointSweep(const cloth::ClothModel& model, const Eliminated& eliminated, std::span<const double> inverseMass,
               double h, double cap);

    [[nodiscard]] bool touches(std::span<const int> particles) const;
    /// |Σ coefficient·x| → restLength
    void add(std::span<const int> particles, std::span<const double> coefficients, double restLength, double stiffness);

    void apply(std::span<Place> places) const;
    [[nodiscard]] std::size_t bytes() const;

private:
    struct Term {
        int particle;
        double coefficient, correction;
    };
    struct Expanded { // a spring or stencil
        int begin, end;
        double restLength;
    };

    [[nodiscard]] double compliance(double stiffness, double inverseMass) const;
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
    std::vector<Expanded> expanded_;
    std::vector<Term> terms_;
    std::vector<int> triangles_, cells_, hinges_;
};

} // namespace toile::dynamics
