// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Sew.h"

#include <QtGlobal>

namespace toile::simulation {

/// Of a scene that can be simulated.
inline Simulation simulationOf(const Scene& scene) {
    auto simulation = Simulation::create(scene);
    if (!simulation) qFatal("%s", toString(simulation.error()).c_str());
    return std::move(*simulation);
}

inline void run(Simulation& simulation, int frames) {
    for (int frame = 0; frame < frames; ++frame)
        if (const auto done = simulation.advance(); !done) qFatal("%s", toString(done.error()).c_str());
}

/// Where the nodes of a piece are [m].
inline std::vector<Vec3> nodesOf(const Simulation& simulation, std::size_t piece) {
    const Garment& garment = simulation.garment();
    const std::vector<Vec3> nodes = simulation.nodePositions();
    const auto first = nodes.begin() + garment.particles.firstNode[piece];
    return {first, first + std::ssize(garment.mesh->pieces[piece].nodes)};
}

inline SewReport sewn(Simulation& simulation, const SewSettings& settings = {}) {
    auto report = sew(simulation, settings);
    if (!report) qFatal("%s", toString(report.error()).c_str());
    return std::move(*report);
}

inline SewReport sewn(const Scene& scene, const SewSettings& settings = {}) {
    Simulation simulation = simulationOf(scene);
    return sewn(simulation, settings);
}

} // namespace toile::simulation
