// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/StiffnessMap.h"

#include "core/dynamics/SymplecticEuler.h"
#include "core/study/Trajectory.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <map>

namespace toile::study::stability {
namespace {

using dynamics::Method;

constexpr double wholeTime = 0.4; // [s]

bool isImplicit(Method method) {
    return method == Method::backwardEuler || method == Method::trBdf2;
}

int stepsOf(const MapSettings& settings, Method method, double step) {
    const int whole = static_cast<int>(std::lround(wholeTime / step));
    return std::min(whole, isImplicit(method) ? settings.mostImplicitSteps : settings.mostSteps);
}

/// Where the flap really is after a time: by fourth-order steps well below their limit where those are affordable, else
/// by TR-BDF2 in 1500 steps.
class Truth {
public:
    explicit Truth(const Scene& scene) : scene_(scene) {}
    const std::vector<Vec3>& at(double time) {
        if (const auto known = known_.find(time); known != known_.end()) return known->second;
        dynamics::ParticleState state = scene_.start;
        const auto fourth = dynamics::makeIntegrator(Method::rk4, scene_.model, {.damping = scene_.damping});
        const double limit = 0.5 * fourth->stepLimit(state.positions);
        const bool affordable = time / limit < 40000;
        const auto exact = affordable ? nullptr
                                      : dynamics::makeIntegrator(Method::trBdf2, scene_.model,
                                                                 {.damping = scene_.damping, .tolerance = 1e-8});
        const int steps = affordable ? static_cast<int>(std::ceil(time / limit)) : 1500;
        for (int i = 0; i < steps; ++i)
            if (!(affordable ? fourth : exact)->step(state, time / steps, scene_.gravity)) break;
        return known_[time] = state.positions;
    }

private:
    const Scene& scene_;
    std::map<double, std::vector<Vec3>> known_;
};

/// Symplectic Euler that refuses what it cannot do.
Watched explicitly(const Scene& scene, dynamics::ParticleState& state, double step, int steps) {
    const dynamics::SymplecticEuler euler(scene.model, {.damping = scene.damping, .automaticSubsteps = false});
    if (const double limit = euler.stepLimit(state.positions); step > limit)
        return {.refused = true,
                .stopped =
                    fmt::format("A step of {:.3g} s is beyond the limit of {:.3g} s of explicit steps.", step, limit)};
    return watched(scene.model, state,
                   {Method::symplecticEuler, {.damping = scene.damping}, step, steps, scene.gravity});
}

/// Used over true stiffness, summed over the springs that can move.
double softeningOf(const Scene& scene, double h, double cap) {
    const cloth::ClothModel soft = capped(scene.model, h, cap);
    const auto isHeld = [&](int particle) { return std::ranges::binary_search(scene.model.pinned, particle); };
    double used = 0, wanted = 0;
    for (std::size_t s = 0; s < soft.structural.size(); ++s) {
        if (isHeld(soft.structural[s].a) && isHeld(soft.structural[s].b)) continue;
        used += soft.structural[s].stiffness;
        wanted += scene.model.structural[s].stiffness;
    }
    return used / wanted;
}

MapCell cellOf(const Scene& scene, Truth& truth, const MapSettings& settings, const MapMethod& method, double step) {
    MapCell cell{method.name, scene.stiffness, step};
    const int steps = stepsOf(settings, method.method, step);
    cell.duration = steps * step;
    cell.stepLimit = stepLimitOf(scene, Method::symplecticEuler);
    dynamics::ParticleState state = scene.start;
    cell.run = method.method == Method::symplecticEuler
                   ? explicitly(scene, state, step, steps)
                   : watched(scene.model, state,
                             {method.method,
                              {.damping = scene.damping, .substeps = 1, .stiffnessCap = method.stiffnessCap},
                              step,
                              steps,
                              scene.gravity});
    if (method.method == Method::xpbd) cell.softened = softeningOf(scene, step, method.stiffnessCap);
    cell.bounded = cell.run.refused || (cell.run.stopped.empty() &&
                                        cell.run.metrics.energyGrowth.value_or(0) <= allowedGrowth(method.method));
    cell.error = std::numeric_limits<double>::quiet_NaN();
    if (cell.run.refused || !cell.run.stopped.empty()) return cell;
    const auto& exact = truth.at(cell.duration);
    cell.error = rmsDistance(scene, state.positions, exact) / rmsDistance(scene, scene.start.positions, exact);
    return cell;
}

} // namespace

std::vector<MapMethod> mapMethods() {
    return {{"symplectic Euler", Method::symplecticEuler, 1},
            {"XPBD, cap 1", Method::xpbd, 1},
            {"XPBD without cap", Method::xpbd, 1e30},
            {"backward Euler", Method::backwardEuler, 1},
            {"TR-BDF2", Method::trBdf2, 1}};
}

MapSettings mapSettings(bool quick) {
    if (quick) return {8, {1e0, 1e3, 1e6, 1e9}, {1e-4, 1e-3, 1.0 / 60, 0.1}, 4000, 100};
    MapSettings settings{.steps = {1e-5, 1e-4, 1e-3, 1.0 / 240, 1.0 / 60, 0.1}};
    for (int decade = 0; decade <= 9; ++decade) settings.stiffnesses.push_back(std::pow(10.0, decade));
    return settings;
}

std::vector<MapCell> stiffnessMap(const MapSettings& settings) {
    std::vector<MapCell> cells;
    for (const double stiffness : settings.stiffnesses) {
        const Scene scene = *sceneNamed("flap", {settings.cells, stiffness / 50});
        Truth truth(scene);
        for (const MapMethod& method : mapMethods())
            for (const double step : settings.steps) cells.push_back(cellOf(scene, truth, settings, method, step));
    }
    return cells;
}

} // namespace toile::study::stability
