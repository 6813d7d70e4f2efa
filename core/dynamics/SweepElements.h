// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"

#include <array>
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

/// What tension curves make of elements, from their strains.
class TensionLaw {
public:
    virtual ~TensionLaw() = default;
    /// Sets the coupling of the given four, and the compliance of all constraints that a curve has a say in.
    virtual void bend(int four, const FourNumbers& weft, const FourNumbers& warp, FourNumbers& coupling,
                      std::span<FourNumbers> compliance) const = 0;
};

} // namespace toile::dynamics
