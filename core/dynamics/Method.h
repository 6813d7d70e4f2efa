// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/Integrator.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace toile::dynamics {

/// The methods of integration by the names that the command line gives them.
enum class Method {
    xpbd,
    trBdf2,
    backwardEuler,
    bdf2,
    midpoint,
    sdirk4,
    rk4,
    symplecticEuler,
    subcycledEuler,
    baraffWitkin
};

[[nodiscard]] std::span<const Method> allMethods();
[[nodiscard]] std::string_view nameOf(Method method);
[[nodiscard]] std::optional<Method> methodNamed(std::string_view name);

struct IntegratorSettings {
    double damping = 0.5;                        ///< mass-proportional [1/s]
    int substeps = 0;                            ///< of XPBD; 0 = from the mesh, for a transport error of 2 mm
    double stiffnessCap = 1;                     ///< of XPBD: XpbdSettings
    double speedLimit = 0;                       ///< of XPBD [m/s]; 0 = none
    double tolerance = 1e-4;                     ///< of implicit methods: ImplicitSettings
    int gradientIterations = 200;                ///< of implicit methods: ImplicitSettings
    std::optional<std::size_t> factorBytes = {}; ///< of implicit methods: MinimiserSettings
    double positionTolerance = 0;                ///< of TR-BDF2: AdaptiveSettings [m]; 0 = steps as they are given
};

/// The model is borrowed.
[[nodiscard]] std::unique_ptr<Integrator> makeIntegrator(Method method, const cloth::ClothModel& model,
                                                         const IntegratorSettings& settings);

} // namespace toile::dynamics
