// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Team.h"
#include "core/cloth/ClothModel.h"
#include "core/dynamics/CurvedMembranes.h"
#include "core/dynamics/JointSweep.h"
#include "core/dynamics/SweepKernels.h"

#include <cstddef>
#include <span>
#include <vector>

namespace toile::dynamics {

/// The elements of a cloth compiled for one substep length: flat arrays in the order of the sweep, colour by colour.
/// Elements of a colour share no particle, so that the processor can take four at a time.
class XpbdSweep {
public:
    /// h substep [s], cap κ of XpbdSettings.
    XpbdSweep(const cloth::ClothModel& model, const Eliminated& eliminated, std::span<const double> inverseMass,
              double h, double cap, const SweepKernels& kernels = fastestKernels());

    /// One Gauss–Seidel pass over all elements. Slaves are read through their masters and not written. With a team the
    /// elements of a colour are shared out, where they are many: the bits are the same.
    void apply(std::span<Vec3> positions, Team* team = nullptr);
    [[nodiscard]] std::size_t bytes() const;

private:
    void compileSprings();
    void compileStencils();
    void compileTriangles();
    void compileCells();
    void compileHinges();
    template <int N>
    [[nodiscard]] LinearElement<N> compiled(const cloth::Stencil& stencil) const;
    [[nodiscard]] double compliance(double stiffness) const;
    [[nodiscard]] int spare(int lane, int corner) const;

    const cloth::ClothModel& model_;
    std::span<const double> inverseMass_;
    double h_, cap_;
    const SweepKernels& kernels_;
    JointSweep joints_;
    std::vector<Place> places_; ///< all particles, then the corners of lanes without an element
    std::vector<FourSprings> springs_;
    std::vector<LinearElement<3>> threePoint_;
    std::vector<LinearElement<4>> fourPoint_;
    std::vector<FourTriangles> triangles_;
    std::vector<FourCells> cells_;
    std::vector<FourHinges> hinges_;
    struct Borders { ///< elements between two of them share no particle
        std::vector<int> springs, triangles, cells, threePoint, fourPoint, hinges;
    };
    Borders borders_;
    CurvedMembranes curvedTriangles_, curvedCells_; ///< empty where all is linear
};

} // namespace toile::dynamics
