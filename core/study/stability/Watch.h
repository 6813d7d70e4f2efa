// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Method.h"

#include <functional>
#include <optional>
#include <string>

namespace toile::study::stability {

/// What a run that was watched has shown. What was not measured is absent.
struct Metrics {
    std::optional<double> energyGrowth;  ///< most that the total stood above its start, over what was turned over [–]
    std::optional<double> speed;         ///< largest of a particle [m/s]
    std::optional<double> strain;        ///< largest stretch of a spring [–]
    std::optional<double> residual;      ///< largest force left unsolved over the mean particle weight [–]
    std::optional<double> newtonPerStep; ///< iterations
    std::optional<double> distance;      ///< least, of what is to be kept apart [m]; negative = inside
    int divided = 0;                     ///< parts that were made again, smaller
    double seconds = 0;                  ///< of this thread's processor time
};

/// The larger of both, by field.
[[nodiscard]] Metrics worst(const Metrics& a, const Metrics& b);

struct WatchSettings {
    dynamics::Method method = dynamics::Method::trBdf2;
    dynamics::IntegratorSettings integrator;
    double step = 1.0 / 60; ///< [s]
    int steps = 60;
    Vec3 gravity{0, -9.81, 0};
    double timeLimit = 60;                                        ///< of this thread's processor time [s]
    std::function<void(dynamics::ParticleState&)> afterStep = {}; ///< looks, or moves what is held
};

/// What came of it.
struct Watched {
    Metrics metrics;
    int steps = 0;        ///< that were made
    bool refused = false; ///< before the first step, with a sentence
    std::string stopped;  ///< the sentence with which it ended early; else empty
    bool solved = true;   ///< no part missed its tolerance
};

/// Energy may rise so much over what was turned over: 0.1 % by backward Euler, which only loses, and 1 % by the others.
/// Symplectic Euler keeps another energy, and the true one swings about it by up to 1/(1 − (ωh/2)²), 5 at 0.9 of its
/// limit; beyond the limit it grows without end.
[[nodiscard]] double allowedGrowth(dynamics::Method method);

/// Steps a cloth and looks at it after each. Position-based dynamics is judged by the energy of the cloth that its cap
/// makes of it.
[[nodiscard]] Watched watched(const cloth::ClothModel& model, dynamics::ParticleState& state,
                              const WatchSettings& settings, std::span<dynamics::Stage* const> stages = {});

/// Largest stretch of a structural spring [–].
[[nodiscard]] double stretchOf(const cloth::ClothModel& model, std::span<const Vec3> positions);

/// The cloth as position-based substeps of this length see it: no element is stiffer than cap/(w h²).
[[nodiscard]] cloth::ClothModel capped(cloth::ClothModel model, double h, double cap);

} // namespace toile::study::stability
