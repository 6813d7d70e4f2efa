// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"
#include "core/dynamics/Stage.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace toile::study {

/// A cloth that is let go, and for how long it is watched.
struct Scene {
    std::string name;
    cloth::ClothModel model;
    dynamics::ParticleState start;
    Vec3 gravity{0, -9.81, 0}; ///< [m/s²]
    double damping = 0.5;      ///< mass-proportional [1/s]
    double duration = 0.4;     ///< [s]
    double size = 1;           ///< of the piece [m]; errors are also given as parts of it
    double stiffness = 0;      ///< of the cloth along warp and weft [N/m]
};

struct SceneSettings {
    int cells = 16;             ///< along a side
    double stiffnessFactor = 1; ///< of the soft cloth of 50 N/m
};

/// "oscillator", "flap", "two-corners".
[[nodiscard]] std::span<const std::string_view> sceneNames();

/// A built-in scene by its name; nothing for another name.
///
/// oscillator: a kilogram on a spring of 100 N/m times the factor, pulled out by a tenth, without weight or damping.
/// flap: a sheet of 1 m, let go level with one edge held. two-corners: the same held at two corners.
[[nodiscard]] std::optional<Scene> sceneNamed(std::string_view name, const SceneSettings& settings);

} // namespace toile::study
