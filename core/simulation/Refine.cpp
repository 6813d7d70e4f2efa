// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Refine.h"

#include "core/simulation/HangsBy.h"

namespace toile::simulation {

Result<Refined> refined(Simulation coarse, Scene scene, const MeshOverrides& fine, const SewSettings& settings,
                        StiffBand stiff, std::stop_token stop, const Progress& progress) {
    SewSettings unfinished = settings;
    unfinished.seconds.reset();
    unfinished.finish = false;
    const auto sewn = sew(coarse, unfinished, stop, progress);
    if (!sewn) return tl::unexpected(sewn.error());
    auto simulation = Simulation::continued(std::move(scene), coarse, fine);
    if (!simulation) return tl::unexpected(simulation.error());
    if (stiff == StiffBand::byInertia) simulation->hangBy(nodesItHangsBy(coarse, *simulation));
    return Refined{std::move(*simulation),
                   {.particles = sewn->particles,
                    .steps = sewn->steps,
                    .simulatedSeconds = sewn->simulatedSeconds,
                    .heldSeconds = sewn->heldSeconds,
                    .sleptSeconds = sewn->sleptSeconds,
                    .sleptSavedSeconds = sewn->sleptSavedSeconds,
                    .sleptApartSteps = sewn->sleptApartSteps,
                    .sleptApartSavedSeconds = sewn->sleptApartSavedSeconds,
                    .cpuSeconds = sewn->cpuSeconds,
                    .wallSeconds = sewn->wallSeconds,
                    .ending = sewn->ending}};
}

SewSettings settingsAfter(const CoarseRun& coarse, SewSettings settings) {
    if (coarse.heldSeconds > 0) settings.hold = 0;
    return settings;
}

void count(const CoarseRun& coarse, SewReport& report) {
    report.heldSeconds += coarse.heldSeconds;
    report.sleptSeconds += coarse.sleptSeconds;
    report.sleptSavedSeconds += coarse.sleptSavedSeconds;
    report.sleptApartSteps += coarse.sleptApartSteps;
    report.sleptApartSavedSeconds += coarse.sleptApartSavedSeconds;
    report.cpuSeconds += coarse.cpuSeconds;
    report.wallSeconds += coarse.wallSeconds;
    if (report.restWallSeconds) *report.restWallSeconds += coarse.wallSeconds;
    report.coarse = coarse;
}

} // namespace toile::simulation
