// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Shared.h"
#include "core/body/Landmarks.h"
#include "core/pattern/Pattern.h"

#include <cstddef>
#include <optional>

namespace toile::simulation {

/// Air that drags at the cloth.
struct Air {
    Vec3 wind;         ///< its velocity; zero = still air, in which falling cloth sails [m/s]
    double drag = 1.2; ///< coefficient of cloth across the stream (docs/physics/air.md) [–]
    friend bool operator==(const Air&, const Air&) = default;
};

/// The world the garment lives in, and how carefully it is simulated.
struct SceneSettings {
    Vec3 gravity{0, -9.81, 0};   ///< [m/s²]
    double damping = 0.5;        ///< mass-proportional [1/s]
    double strainDamping = 0;    ///< stiffness-proportional, β of dynamics::StrainDamping [s]
    double skinOffset = 0.003;   ///< distance of the cloth's underside to the body [m]
    double bodyFriction = 0.3;   ///< μ of the body; a pair has √(μ₁·μ₂) [–]
    double seamTime = 0.6;       ///< in which seams are drawn together [s]
    double frameStep = 1.0 / 60; ///< [s]
    int substeps = 0;            ///< of a frame step; 0 = from the mesh (docs/physics/xpbd.md)
    bool selfContact = false;
    std::optional<Air> air; ///< absent = none
    friend bool operator==(const SceneSettings&, const SceneSettings&) = default;
};

/// Everything that determines a simulation; a value that can be handed to another thread.
struct Scene {
    pattern::Pattern pattern;
    std::optional<Shared<body::Body>> body;
    SceneSettings settings;
    bool paper = false; ///< the method of the 2002 paper from end to end, to compare with (docs/physics/paper.md)
    std::optional<std::size_t> memory = {}; ///< that it may take [B]; absent = what the machine can give
    friend bool operator==(const Scene&, const Scene&) = default;
};

} // namespace toile::simulation
