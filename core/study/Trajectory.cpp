// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Trajectory.h"

#include "core/base/Contracts.h"
#include "core/study/Calibration.h"

#include <algorithm>
#include <cmath>

namespace toile::study {
namespace {

dynamics::IntegratorSettings settingsOf(const Scene& scene, const Setup& setup) {
    return {.damping = scene.damping, .substeps = setup.substeps, .tolerance = setup.tolerance};
}

} // namespace

Result<Trajectory> trajectoryOf(const Scene& scene, const Setup& setup, std::stop_token stop) {
    expects(setup.steps > 0 && setup.substeps > 0, "time is divided into some steps");
    const int perSample = (setup.steps + sampleCount - 1) / sampleCount;
    const double step = scene.duration / (perSample * sampleCount);
    const double start = threadSeconds();
    const auto integrator = dynamics::makeIntegrator(setup.method, scene.model, settingsOf(scene, setup));
    dynamics::ParticleState state = scene.start;
    Trajectory trajectory{.report = {.parts = 0}};
    for (int sample = 0; sample < sampleCount; ++sample) {
        for (int i = 0; i < perSample; ++i) {
            const auto done = integrator->step(state, step, scene.gravity, {}, stop);
            if (!done) return tl::unexpected(done.error());
            trajectory.report += *done;
        }
        trajectory.samples.push_back(state.positions);
    }
    trajectory.seconds = threadSeconds() - start;
    const auto before = dynamics::energies(scene.model, scene.start, scene.gravity),
               after = dynamics::energies(scene.model, state, scene.gravity);
    const double turnedOver = std::max(before.elastic, before.gravity - after.gravity);
    if (turnedOver > 0) trajectory.energyChange = (after.total() - before.total()) / turnedOver;
    return trajectory;
}

double stepLimitOf(const Scene& scene, dynamics::Method method) {
    return dynamics::makeIntegrator(method, scene.model, {.damping = scene.damping})->stepLimit(scene.start.positions);
}

double rmsDistance(const Scene& scene, const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0, mass = 0;
    for (std::size_t p = 0; p < a.size(); ++p) {
        sum += scene.model.mass[p] * squaredLength(a[p] - b[p]);
        mass += scene.model.mass[p];
    }
    return std::sqrt(sum / mass);
}

TimeError differenceOf(const Scene& scene, const Trajectory& a, const Trajectory& b) {
    TimeError error;
    for (int k = 0; k < sampleCount; ++k) {
        error.rms = rmsDistance(scene, a.samples[k], b.samples[k]);
        error.maximum = std::max(error.maximum, error.rms);
    }
    return error;
}

} // namespace toile::study
