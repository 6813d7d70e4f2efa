// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Method.h"
#include "tests/cloth/Fixtures.h"

namespace toile::fixtures {

/// A square sheet of 1 m, let go level with one edge pinned: the scene in which integrators are compared.
struct Flap {
    ClothModel model;
    dynamics::ParticleState state;
};

constexpr double flapDamping = 0.5; ///< drag of the air [1/s]

/// cells: along a side; factor: of the stiffness 50 N/m in C11 and C22, of which C12 and the shear stiffness
/// are a tenth. 0.2 kg/m², bending stiffness 5e-5 N·m without twist.
inline Flap flap(int cells, double factor) {
    Fabric fabric;
    fabric.name = "flap";
    fabric.arealDensity = 0.2;
    const double modulus = 50 * factor, shear = modulus / 10;
    fabric.warpStiffness = fabric.weftStiffness = modulus - shear * shear / modulus; // uniaxial
    fabric.shearStiffness = shear;
    fabric.warpBending = fabric.weftBending = 5e-5;
    fabric.biasBending = 2.5e-5;
    const Patch patch = gridPatch(evenLines(1, cells), evenLines(1, cells));
    Flap f;
    if (!cloth::appendPatch(f.model, patch, fabric)) return f;
    for (int i = 0; i <= cells; ++i) f.model.pinned.push_back(i);
    for (const Vec2& m : patch.material) f.state.positions.push_back({m.x, 0, m.y});
    f.state.velocities.resize(f.state.positions.size());
    return f;
}

/// Mass-weighted root mean square of the distances [m].
inline double rmsDistance(const ClothModel& model, const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0, mass = 0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        sum += model.mass[p] * squaredLength(a[p] - b[p]);
        mass += model.mass[p];
    }
    return std::sqrt(sum / mass);
}

} // namespace toile::fixtures
