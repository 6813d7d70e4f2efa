// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/Vec.h"
#include "core/material/Fabric.h"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace toile::cloth {

/// E = ½ k (|x_b − x_a| − restLength)²  [J]
struct Spring {
    int a = 0, b = 0;
    double restLength = 0; ///< [m]
    double stiffness = 0;  ///< k [N/m]
};

/// E = ½ k |Σ coefficient·x|²  [J]: three-point bending, twist, and flat hinges (Bergou 2006). The Hessian is
/// constant. Unused places hold particle −1.
struct Stencil {
    std::array<int, 4> particles{-1, -1, -1, -1};
    std::array<double, 4> coefficients{};
    double stiffness = 0;
};

/// Two triangles (a, b, c) and (b, a, d) that share the edge a–b, bent back to a rest angle.
/// E = ½ k (θ − θ₀)²  [J]; θ = 0 flat, positive when the fold's right side closes (mountain seen from the right side
/// is negative).
struct Hinge {
    int a = 0, b = 0, c = 0, d = 0;
    double restAngle = 0; ///< θ₀ [rad]
    double stiffness = 0; ///< k [N·m]; B·e²/A for a rest edge length e and a rest area A of both triangles
};

/// Constant-strain triangle, orthotropic in warp and weft, corotated (Biot) strain.
struct MembraneTriangle {
    std::array<int, 3> particles{};
    std::array<double, 4> inverseRest{}; ///< row-major inverse of [m1−m0, m2−m0] in material coordinates [1/m]
    double area = 0;                     ///< rest [m²]
    material::MembraneStiffness stiffness;
    int tension = -1; ///< as MembraneCell
};

/// Rectangle of a knit: orthotropic membrane with Baraff–Witkin shear and its own C12; optional tension curves.
/// Corners as meshing::Rectangle.
struct MembraneCell {
    std::array<int, 4> particles{};
    double width = 0, height = 0; ///< along weft, along warp [m]
    material::MembraneStiffness stiffness;
    int tension = -1; ///< index into ClothModel::tensionCurves; −1 = linear
};

/// σ(e) = C·f(e)·e for e > 0 with the secant factor f linear between the points and from f(0) = 1, straight on
/// beyond the last; f = 1 in compression.
struct TensionCurves {
    std::vector<material::TensionPoint> warp, weft;
};

/// x = Σ weight · x(master). Masters are not slaves.
struct Slave {
    int particle = 0;
    std::vector<std::pair<int, double>> masters;
};

/// The constant part of a cloth: what it is made of, not where it is. Particles are numbered 0 … particleCount−1.
struct ClothModel {
    std::vector<double> mass; ///< [kg], one per particle; a slave's mass is given to its masters, its own entry is 0
    std::vector<int> pinned;  ///< particles that stay where they are, rising
    std::vector<Slave> slaves;

    std::vector<Spring> structural, shear;
    std::vector<Spring> elastics; ///< bands that are sewn into seams
    std::vector<Spring> flexion;  ///< the paper's skip-one springs; empty but in paper mode
    std::vector<Stencil> bending, twist;
    std::vector<Hinge> hinges;
    std::vector<MembraneTriangle> triangles;
    std::vector<MembraneCell> cells;
    std::vector<TensionCurves> tensionCurves;

    int clampedCells = 0; ///< cells whose spring constants had to be clamped at 0 (paper mode only)

    [[nodiscard]] int particleCount() const { return static_cast<int>(mass.size()); }
};

/// What the arrays of a cloth hold [B].
[[nodiscard]] std::size_t bytesOf(const ClothModel& model);

} // namespace toile::cloth
