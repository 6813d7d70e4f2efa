// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SceneCheck.h"

#include <cmath>
#include <fmt/format.h>

namespace toile::simulation {

namespace {

constexpr double mostDrag = 10;         // [–]
constexpr double mostStrainDamping = 1; // [s]
constexpr double strongestWind = 100;   // [m/s]

} // namespace

std::vector<pattern::Problem> checkScene(const SceneSettings& scene) {
    struct Field {
        const char* path;
        double value;
        bool zeroAllowed;
    };
    const Field fields[] = {
        {"scene.damping", scene.damping, true},       {"scene.strainDamping", scene.strainDamping, true},
        {"scene.skinOffset", scene.skinOffset, true}, {"scene.bodyFriction", scene.bodyFriction, true},
        {"scene.seamTime", scene.seamTime, false},    {"scene.frameStep", scene.frameStep, false},
    };
    std::vector<pattern::Problem> problems;
    const auto add = [&](const char* path, std::string text) {
        problems.push_back({{.path = path}, std::move(text), true});
    };
    if (!geometry::isFinite(scene.gravity)) add("scene.gravity", "Gravity must have three finite numbers.");
    if (scene.air) {
        const Air& air = *scene.air;
        if (!geometry::isFinite(air.wind) || length(air.wind) > strongestWind)
            add("scene.air.wind", fmt::format("Wind must have three numbers, and at most {} m/s.", strongestWind));
        if (!(air.drag >= 0 && air.drag <= mostDrag))
            add("scene.air.drag", fmt::format("Expected between 0 and {}, but found {}.", mostDrag, air.drag));
    }
    for (const Field& f : fields)
        if (!std::isfinite(f.value) || f.value < 0 || (f.value == 0 && !f.zeroAllowed))
            add(f.path,
                fmt::format("Expected a number {} 0, but found {}.", f.zeroAllowed ? "of at least" : "above", f.value));
    if (scene.strainDamping > mostStrainDamping)
        add("scene.strainDamping",
            fmt::format("Expected at most {} s, but found {}.", mostStrainDamping, scene.strainDamping));
    if (scene.frameStep > 0 && !(scene.frameStep >= shortestFrameStep && scene.frameStep <= longestFrameStep))
        add("scene.frameStep", fmt::format("Expected between {} and {} s, but found {}.", shortestFrameStep,
                                           longestFrameStep, scene.frameStep));
    if (scene.substeps < 0 || scene.substeps > mostSubsteps)
        add("scene.substeps",
            fmt::format("Expected between 0 and {} substeps, but found {}.", mostSubsteps, scene.substeps));
    return problems;
}

} // namespace toile::simulation
