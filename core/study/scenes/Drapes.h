// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Scene.h"
#include "core/study/scenes/Case.h"

/// Garments and cloths on bodies, from where they are placed.
namespace toile::study::scenes {

/// What is simulated, and what is wanted of it.
struct DrapeScene {
    std::string name, about;
    simulation::Scene scene;
    std::optional<double> spacing; ///< instead of the document's [m]
    double seconds = 3;            ///< simulated
    bool everyFrame = false;       ///< it is looked at after every frame step, not at the end alone
    bool once = false;             ///< however often others are repeated: it takes long
    std::optional<double> cpuSeconds = {}, cpuPerSecond = {}; ///< goals
};

/// One row: seams left open, particles inside the body, intersections with the body and of the cloth with itself, as
/// the independent exact test counts them, and what it cost from the pattern on, the tests not counted. The worst of
/// all frames that are looked at.
[[nodiscard]] Case drapeCase(DrapeScene scene);

} // namespace toile::study::scenes
