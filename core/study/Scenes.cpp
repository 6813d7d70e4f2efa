// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Scenes.h"

#include "core/base/Contracts.h"
#include "core/cloth/RegularPatches.h"

#include <array>

namespace toile::study {
namespace {

constexpr std::array<std::string_view, 3> names{"oscillator", "flap", "two-corners"};

Scene oscillator(const SceneSettings& settings) {
    Scene scene{.gravity = {}, .damping = 0, .duration = 1, .stiffness = 100 * settings.stiffnessFactor};
    scene.model.mass = {1, 1};
    scene.model.pinned = {0};
    scene.model.structural = {{0, 1, 1, scene.stiffness}};
    scene.start.positions = {{0, 0, 0}, {1.1, 0, 0}};
    scene.start.velocities.resize(2);
    return scene;
}

/// A level square of 1 m: 0.2 kg/m², bending stiffness 5e-5 N·m without twist, shear a tenth of the stretch.
Scene sheet(const SceneSettings& settings) {
    Scene scene;
    scene.stiffness = 50 * settings.stiffnessFactor;
    material::Fabric fabric;
    fabric.name = "test cloth";
    fabric.arealDensity = 0.2;
    const double shear = scene.stiffness / 10;
    fabric.warpStiffness = fabric.weftStiffness = scene.stiffness - shear * shear / scene.stiffness; // uniaxial
    fabric.shearStiffness = shear;
    fabric.warpBending = fabric.weftBending = 5e-5;
    fabric.biasBending = 2.5e-5;
    const auto lines = cloth::evenLines(scene.size, settings.cells);
    const cloth::Patch patch = cloth::gridPatch(lines, lines);
    const auto appended = cloth::appendPatch(scene.model, patch, fabric);
    expects(appended.has_value(), "a square sheet of rectangles is a cloth");
    for (const Vec2& m : patch.material) scene.start.positions.push_back({m.x, 0, m.y});
    scene.start.velocities.resize(scene.start.positions.size());
    return scene;
}

} // namespace

std::span<const std::string_view> sceneNames() {
    return names;
}

std::optional<Scene> sceneNamed(std::string_view name, const SceneSettings& settings) {
    expects(settings.cells > 0 && settings.stiffnessFactor > 0, "a scene has cells and a stiffness");
    std::optional<Scene> scene;
    if (name == "oscillator") scene = oscillator(settings);
    if (name == "flap") {
        scene = sheet(settings);
        for (int i = 0; i <= settings.cells; ++i) scene->model.pinned.push_back(i);
    }
    if (name == "two-corners") {
        scene = sheet(settings);
        scene->model.pinned = {0, settings.cells};
    }
    if (scene) scene->name = name;
    return scene;
}

} // namespace toile::study
