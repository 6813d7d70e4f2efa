// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stability/Watch.h"

#include "core/dynamics/Energy.h"
#include "core/dynamics/Xpbd.h"
#include "core/study/Calibration.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace toile::study::stability {
namespace {

using dynamics::Energies;
using dynamics::Method;

double speedOf(const dynamics::ParticleState& state) {
    double most = 0;
    for (const Vec3& v : state.velocities) most = std::max(most, length(v));
    return most;
}

/// Rise of the total energy over the start, measured by what moved between its forms.
class EnergyWatch {
public:
    EnergyWatch(const Energies& start, double mass)
        : start_(start), scale_(std::max(start.kinetic + start.elastic, mass * still * still)) {}
    void look(const Energies& now) {
        rise_ = std::max(rise_, now.total() - start_.total());
        scale_ = std::max(
            {scale_, now.kinetic, std::abs(now.gravity - start_.gravity), std::abs(now.elastic - start_.elastic)});
    }
    [[nodiscard]] double growth() const { return rise_ / scale_; }

private:
    static constexpr double still = 1e-6; ///< what is slower does not move [m/s]

    Energies start_;
    double rise_ = 0, scale_ = 0;
};

std::optional<double> largest(std::optional<double> a, std::optional<double> b) {
    return a && b ? std::max(*a, *b) : a ? a : b;
}

} // namespace

double stretchOf(const cloth::ClothModel& model, std::span<const Vec3> positions) {
    double most = 0;
    for (const cloth::Spring& s : model.structural)
        if (s.restLength > 0)
            most = std::max(most, geometry::distance(positions[s.a], positions[s.b]) / s.restLength - 1);
    return most;
}

Metrics worst(const Metrics& a, const Metrics& b) {
    std::optional<double> distance = a.distance ? a.distance : b.distance;
    if (a.distance && b.distance) distance = std::min(*a.distance, *b.distance);
    return {largest(a.energyGrowth, b.energyGrowth),
            largest(a.speed, b.speed),
            largest(a.strain, b.strain),
            largest(a.residual, b.residual),
            largest(a.newtonPerStep, b.newtonPerStep),
            distance,
            a.divided + b.divided,
            a.seconds + b.seconds};
}

double allowedGrowth(Method method) {
    if (method == Method::symplecticEuler) return 5;
    return method == Method::backwardEuler || method == Method::baraffWitkin ? 0.001 : 0.01;
}

cloth::ClothModel capped(cloth::ClothModel model, double h, double cap) {
    const std::vector<double> inverseMass = dynamics::Eliminated(model).inverseMass();
    const auto limit = [&](double& stiffness, double w) {
        if (w > 0) stiffness = std::min(stiffness, cap / (w * h * h));
    };
    for (auto* springs : {&model.structural, &model.shear, &model.elastics, &model.flexion})
        for (cloth::Spring& s : *springs) limit(s.stiffness, inverseMass[s.a] + inverseMass[s.b]);
    for (auto* stencils : {&model.bending, &model.twist})
        for (cloth::Stencil& s : *stencils) {
            double w = 0;
            for (int k = 0; k < 4; ++k)
                if (s.particles[k] >= 0) w += s.coefficients[k] * s.coefficients[k] * inverseMass[s.particles[k]];
            limit(s.stiffness, w);
        }
    return model;
}

Watched watched(const cloth::ClothModel& model, dynamics::ParticleState& state, const WatchSettings& settings,
                std::span<dynamics::Stage* const> stages) {
    Watched out;
    const double start = threadSeconds();
    const auto integrator = dynamics::makeIntegrator(settings.method, model, settings.integrator);
    cloth::ClothModel softened;
    if (settings.method == Method::xpbd) {
        const int substeps =
            settings.integrator.substeps > 0
                ? settings.integrator.substeps
                : dynamics::substepsFor(settings.step, dynamics::springsOnLongestLine(model), length(settings.gravity));
        softened = capped(model, settings.step / substeps, settings.integrator.stiffnessCap);
    }
    const cloth::ClothModel& seen = settings.method == Method::xpbd ? softened : model;
    state.velocities.resize(state.positions.size());
    EnergyWatch energy(dynamics::energies(seen, state, settings.gravity),
                       std::accumulate(model.mass.begin(), model.mass.end(), 0.0));
    dynamics::StepReport sum{.parts = 0};
    double speed = speedOf(state), strain = stretchOf(model, state.positions);
    for (int step = 0; step < settings.steps; ++step) {
        if (threadSeconds() - start > settings.timeLimit) {
            out.stopped = fmt::format("It took more than {:g} s.", settings.timeLimit);
            break;
        }
        const auto done = integrator->step(state, settings.step, settings.gravity, stages);
        if (!done) {
            out.stopped = done.error().text;
            out.refused = step == 0 && done.error().code == ErrorCode::invalidInput;
            break;
        }
        ++out.steps;
        sum += *done;
        energy.look(dynamics::energies(seen, state, settings.gravity));
        speed = std::max(speed, speedOf(state));
        strain = std::max(strain, stretchOf(model, state.positions));
        if (settings.afterStep) settings.afterStep(state);
    }
    out.metrics.seconds = threadSeconds() - start;
    out.solved = sum.accurate;
    if (out.steps == 0) return out;
    out.metrics.energyGrowth = energy.growth();
    out.metrics.speed = speed;
    out.metrics.strain = strain;
    out.metrics.divided = sum.repeated;
    if (sum.newtonIterations > 0) {
        out.metrics.residual = sum.residual;
        out.metrics.newtonPerStep = static_cast<double>(sum.newtonIterations) / out.steps;
    }
    return out;
}

} // namespace toile::study::stability
