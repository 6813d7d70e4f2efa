// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <limits>
#include <span>

namespace toile::dynamics {

/// A particle as the loops of a sweep load and store it: at once.
struct alignas(32) Place : Vec3 {
    double inverseMass = 0; ///< [1/kg]
    friend bool operator==(const Place&, const Place&) = default;
};

/// Elements as a sweep reads them, small, because it waits for memory more than for anything else. What stands for a
/// stiffness alone may be `float`, wrong by 6e-8 of itself; never what cloth at rest or a sum of forces rests on.
/// "Four" are four elements that share no particle, side by side.
///
/// Compliance is 1/(k h²) [1/kg], infinite for an element without stiffness.
using FourNumbers = std::array<double, 4>;
using FourIndices = std::array<int, 4>;

struct alignas(16) FourSprings {
    FourNumbers restLength{};     ///< [m]
    std::array<float, 4> share{}; ///< 1/(w_a + w_b + compliance) [kg]
    FourIndices a{}, b{};
};

/// |Σ c·(x − x_last)| → 0 over all but the last particle; Σ c over all is 0.
template <int N>
struct LinearElement {
    std::array<double, N - 1> coefficients{};
    std::array<int, N> particles{};
    float share = 0; ///< 1/(Σ w c² + compliance)
};

struct alignas(32) FourTriangles {
    std::array<FourNumbers, 4> inverseRest{};
    FourNumbers coupling{};                  ///< C12/C22
    std::array<FourNumbers, 3> compliance{}; ///< of weft, of warp with its coupling, of shear
    std::array<FourIndices, 3> particles{};
};

struct alignas(32) FourCells {
    FourNumbers perWidth{}, perHeight{}; ///< [1/m]
    FourNumbers coupling{};
    std::array<FourNumbers, 5> compliance{}; ///< as of triangles, but shear last; between, half differences of sides
    std::array<FourIndices, 4> particles{};
};

struct alignas(32) FourHinges {
    FourNumbers restAngle{};
    FourNumbers compliance{};
    std::array<FourIndices, 4> particles{}; ///< a, b, c, d
};

/// Coarse triangles (CoarseLevels): F_u = Σ u·x, F_v = Σ v·x of their corners.
struct alignas(32) FourLevelTriangles {
    std::array<FourNumbers, 3> u{}, v{};  ///< [1/m]
    std::array<FourNumbers, 3> factors{}; ///< of weft, warp and shear: 1/(w + compliance); 0 = nothing is missing
    FourNumbers weft{}, warp{};           ///< |F_u|, |F_v| when the cloth in it is flat
    FourNumbers shear{};                  ///< F_u·F_v when the cloth in it is not sheared
    FourNumbers flatness{};               ///< part of the factors that acts: 1 of flat cloth, 0 of folded
    std::array<FourIndices, 3> particles{};
};

/// What the tension curves of four membranes need to know of them. A lane without one has no area.
struct alignas(32) FourMembranes {
    FourNumbers area{};              ///< [m²]
    FourNumbers c11{}, c22{}, c12{}; ///< at no strain [N/m]
    int weft = 0, warp = 0;          ///< their curves, indices into TensionLaw::curves
};

/// From a strain on four curves go as factor + rise·(e − strain)/run.
struct alignas(32) FourBends {
    FourNumbers strain{infiniteStrain, infiniteStrain, infiniteStrain, infiniteStrain}; ///< none here
    FourNumbers factor{}, rise{}, run{};

    static constexpr double infiniteStrain = std::numeric_limits<double>::infinity();
};

/// Secant moduli over those at no strain, of four membranes: 1, and from bend to bend as that says. Beyond the last
/// point stress grows along the tangent.
struct alignas(32) FourCurves {
    FourNumbers last{FourBends::infiniteStrain, FourBends::infiniteStrain, FourBends::infiniteStrain,
                     FourBends::infiniteStrain}; ///< strain of the last point
    FourNumbers stress{}, tangent{};             ///< there, for a modulus of 1
    int first = 0, end = 0;                      ///< indices into TensionLaw::bends
};

/// What tension curves make of elements. Ref: cloth::tensionSecant
struct TensionLaw {
    std::span<const FourMembranes> fours; ///< one for each four elements; none where all is linear
    std::span<const FourCurves> curves;
    std::span<const FourBends> bends;
    double h = 0; ///< [s]
};

} // namespace toile::dynamics
