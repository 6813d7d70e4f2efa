// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Integrator.h"
#include "tests/cloth/Fixtures.h"
#include "tests/dynamics/Constants.h"

namespace toile::fixtures {

/// A piece of cloth, and where it is.
struct Specimen {
    ClothModel model;
    dynamics::ParticleState state;
};

inline void run(dynamics::Integrator& integrator, dynamics::ParticleState& state, int steps, double step,
                const Vec3& acceleration = gravity) {
    for (int i = 0; i < steps; ++i)
        if (const auto done = integrator.step(state, step, acceleration); !done)
            qFatal("%s", toString(done.error()).c_str());
}

} // namespace toile::fixtures
