// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Method.h"

#include "core/base/Contracts.h"
#include "core/dynamics/AdaptiveTrBdf2.h"
#include "core/dynamics/BaraffWitkin.h"
#include "core/dynamics/Bdf2.h"
#include "core/dynamics/RungeKutta4.h"
#include "core/dynamics/SubcycledEuler.h"
#include "core/dynamics/SymplecticEuler.h"
#include "core/dynamics/XpbdIntegrator.h"

#include <algorithm>
#include <array>
#include <utility>

namespace toile::dynamics {
namespace {

constexpr std::array<std::pair<Method, std::string_view>, 10> names{{{Method::xpbd, "xpbd"},
                                                                     {Method::trBdf2, "trbdf2"},
                                                                     {Method::backwardEuler, "backward-euler"},
                                                                     {Method::bdf2, "bdf2"},
                                                                     {Method::midpoint, "midpoint"},
                                                                     {Method::sdirk4, "sdirk4"},
                                                                     {Method::rk4, "rk4"},
                                                                     {Method::symplecticEuler, "symplectic-euler"},
                                                                     {Method::subcycledEuler, "subcycled-euler"},
                                                                     {Method::baraffWitkin, "baraff-witkin"}}};

} // namespace

std::span<const Method> allMethods() {
    static constexpr auto methods = [] {
        std::array<Method, names.size()> all{};
        std::ranges::transform(names, all.begin(), [](const auto& row) { return row.first; });
        return all;
    }();
    return methods;
}

std::string_view nameOf(Method method) {
    return std::ranges::find(names, method, [](const auto& row) { return row.first; })->second;
}

std::optional<Method> methodNamed(std::string_view name) {
    const auto row = std::ranges::find(names, name, [](const auto& each) { return each.second; });
    return row == names.end() ? std::nullopt : std::optional(row->first);
}

std::unique_ptr<Integrator> makeIntegrator(Method method, const cloth::ClothModel& model,
                                           const IntegratorSettings& settings) {
    const ImplicitSettings implicit{.damping = settings.damping,
                                    .tolerance = settings.tolerance,
                                    .gradientIterations = settings.gradientIterations,
                                    .factorBytes = settings.factorBytes};
    const auto rungeKutta = [&](const ButcherTableau& tableau) {
        return std::make_unique<ImplicitRungeKutta>(model, tableau, implicit);
    };
    switch (method) {
    case Method::xpbd:
        return std::make_unique<XpbdIntegrator>(model,
                                                XpbdSettings{.damping = settings.damping,
                                                             .stiffnessCap = settings.stiffnessCap,
                                                             .speedLimit = settings.speedLimit},
                                                settings.substeps);
    case Method::trBdf2:
        if (settings.positionTolerance == 0) return rungeKutta(trBdf2());
        return std::make_unique<AdaptiveTrBdf2>(
            model, AdaptiveSettings{.implicit = implicit, .tolerance = settings.positionTolerance});
    case Method::backwardEuler: return rungeKutta(backwardEuler());
    case Method::bdf2: return std::make_unique<Bdf2>(model, implicit);
    case Method::midpoint: return rungeKutta(implicitMidpoint());
    case Method::sdirk4: return rungeKutta(sdirk4());
    case Method::rk4: return std::make_unique<RungeKutta4>(model, RungeKutta4Settings{.damping = settings.damping});
    case Method::symplecticEuler:
        return std::make_unique<SymplecticEuler>(model, SymplecticEulerSettings{.damping = settings.damping});
    case Method::subcycledEuler:
        return std::make_unique<SubcycledEuler>(model, SubcycledEulerSettings{.damping = settings.damping});
    case Method::baraffWitkin: return std::make_unique<BaraffWitkin>(model, implicit);
    }
    expects(false, "a method without an integrator");
    return nullptr;
}

} // namespace toile::dynamics
