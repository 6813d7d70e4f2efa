// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Energy.h"
#include "core/dynamics/Method.h"
#include "core/study/Scenes.h"

#include <stop_token>

namespace toile::study {

/// A method and how finely it divides time.
struct Setup {
    dynamics::Method method = dynamics::Method::trBdf2;
    int steps = 24;          ///< over the whole scene
    int substeps = 1;        ///< of position-based dynamics, in each step
    double tolerance = 1e-4; ///< of implicit methods: IntegratorSettings
};

/// Where the particles were at evenly spaced times, and what it took.
struct Trajectory {
    std::vector<std::vector<Vec3>> samples; ///< positions at duration·(k+1)/sampleCount [m]
    dynamics::StepReport report;
    double energyChange = 0; ///< of the total, over what the lowering of weight and the tension set free [–]
    double seconds = 0;      ///< of this thread's processor time
};

constexpr int sampleCount = 20;

/// Steps are rounded up so that the samples fall on them. Errors: those of the integrator, cancelled.
[[nodiscard]] Result<Trajectory> trajectoryOf(const Scene& scene, const Setup& setup, std::stop_token stop = {});

/// The longest step at which an explicit method runs undivided on the scene [s]; infinity for the others.
[[nodiscard]] double stepLimitOf(const Scene& scene, dynamics::Method method);

/// Mass-weighted root mean square of the distances [m].
[[nodiscard]] double rmsDistance(const Scene& scene, const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// Distances between two trajectories of one scene.
struct TimeError {
    double rms = 0;     ///< mass-weighted, at the end [m]
    double maximum = 0; ///< the largest of the same over all samples [m]
};
[[nodiscard]] TimeError differenceOf(const Scene& scene, const Trajectory& a, const Trajectory& b);

} // namespace toile::study
