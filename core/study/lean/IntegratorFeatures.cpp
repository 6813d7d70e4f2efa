// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Simulation.h"
#include "core/study/lean/FeatureChapters.h"
#include "core/study/lean/FeatureScenes.h"
#include "core/study/validation/Pieces.h"

namespace toile::study::lean {
namespace {

using pattern::Piece;
using simulation::Scene;
using validation::polygonPiece;

/// A strip of 120 springs that hangs by its upper side.
Scene longStrip() {
    constexpr double spacing = 0.01;
    Piece strip = polygonPiece("strip", {{0, 0}, {0.1, 0}, {0.1, 1.2}, {0, 1.2}}, spacing);
    strip.placement = pattern::Placement{};
    strip.placement->transform.origin = {0, 0.2, 0};
    Scene scene = sceneOf({std::move(strip)});
    pin(scene, "strip", {"v2", "v3"});
    return scene;
}

Scene withSubsteps(Scene scene, int substeps) {
    scene.settings.substeps = substeps;
    return scene;
}

int substepsOf(const Scene& scene) {
    const auto simulation = simulation::Simulation::create(scene);
    return simulation ? simulation->substeps() : 0; // the run will say why
}

Feature coarseLevels() {
    constexpr int wanted = 99;           // of the strip without levels
    const Scene sheet = heldSheet(0.02); // on a finer mesh its substeps would not suffice
    return {"coarse levels",
            "coarse levels",
            {{Role::absent, "the scene says how many substeps", withSubsteps(sheet, substepsOf(sheet))},
             {Role::unused, "so many substeps suffice", sheet, 0},
             {Role::absent, "a strip of 120 springs, all its substeps", withSubsteps(longStrip(), wanted)},
             {Role::inUse, "a strip of 120 springs", longStrip(), 2}}};
}

Feature damping(double spacing) {
    const auto damped = [spacing](double coefficient) {
        Scene scene = heldSheet(spacing);
        scene.settings.damping = coefficient;
        return scene;
    };
    return {"damping",
            "",
            {{Role::absent, "none", damped(0)},
             {Role::forced, "1e-20 1/s", damped(1e-20), 0},
             {Role::inUse, "0.5 1/s", damped(0.5), 0}}};
}

Feature strainDamping(double spacing) {
    const Scene sheet = heldSheet(spacing);
    Scene damped = sheet;
    damped.settings.strainDamping = 0.005;
    return {"strain damping",
            "strain damping",
            {{Role::absent, "none", sheet},
             {Role::forced, "none, built all the same", sheet, 0, {"strain damping"}},
             {Role::inUse, "5 ms", damped, 0}}};
}

} // namespace

std::vector<Feature> integratorFeatures(double spacing) {
    return {damping(spacing), strainDamping(spacing), coarseLevels()};
}

} // namespace toile::study::lean
