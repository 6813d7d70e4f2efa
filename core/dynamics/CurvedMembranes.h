// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/dynamics/SweepElements.h"

#include <array>
#include <cstddef>
#include <map>
#include <vector>

namespace toile::dynamics {

/// What a sweep takes a membrane for, but for the shear: ½(C11 − C12²/C22)·E_xx² + ½C22·(E_yy + r·E_xx)² with
/// r = C12/C22; cells also have C11 and C22 themselves.
struct Membrane {
    double area = 0; ///< [m²]; 0 = a lane without one
    material::MembraneStiffness stiffness;
    int tension = -1; ///< index into the cloth's curves; −1 = linear

    struct Slack {
        double coupling = 0;                ///< r
        std::array<double, 4> compliance{}; ///< [1/kg]
    };
    /// In substeps of h [s], where no curve has a say.
    [[nodiscard]] Slack slack(double h) const;
};

/// 1/(k h²) [1/kg]
[[nodiscard]] double complianceOf(double stiffness, double h);

/// The tension curves of membranes in fours, side by side as the loops of a sweep read them.
class CurvedMembranes {
public:
    /// The next four.
    void add(const std::array<Membrane, 4>& four, const std::vector<cloth::TensionCurves>& curves);

    /// None has a curve.
    [[nodiscard]] bool areLinear() const { return areLinear_; }
    /// For substeps of h [s]; valid until the next add().
    [[nodiscard]] TensionLaw law(double h) const { return {fours_, curves_, bends_, h}; }
    [[nodiscard]] std::size_t bytes() const;

private:
    using Points = std::vector<material::TensionPoint>;
    int curveOf(const std::array<const Points*, 4>& lanes);

    std::vector<FourMembranes> fours_;
    std::vector<FourCurves> curves_;
    std::vector<FourBends> bends_;
    std::map<std::array<const Points*, 4>, int> known_; ///< garments have few fabrics, and so few fours of curves
    bool areLinear_ = true;
};

} // namespace toile::dynamics
