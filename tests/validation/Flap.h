// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Method.h"
#include "core/study/Scenes.h"
#include "tests/cloth/Fixtures.h"

namespace toile::fixtures {

/// A square sheet of 1 m, let go level with one edge pinned: the scene in which integrators are compared.
struct Flap {
    ClothModel model;
    dynamics::ParticleState state;
};

constexpr double flapDamping = 0.5; ///< drag of the air [1/s]

/// cells: along a side; factor: of the stiffness 50 N/m.
inline Flap flap(int cells, double factor) {
    study::Scene scene = *study::sceneNamed("flap", {cells, factor});
    return {std::move(scene.model), std::move(scene.start)};
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
