// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SeamClosing.h"

#include <algorithm>
#include <cmath>

namespace toile::simulation {

SeamClosing::SeamClosing(std::vector<SeamPair> pairs, SeamClosingSettings settings, std::span<const double> mass)
    : pairs_(std::move(pairs)), settings_(settings) {
    std::vector<double> rows(mass.size(), 0.0); // Gershgorin's
    for (const SeamPair& pair : pairs_)
        for (const int particle : {pair.a, pair.b}) rows[particle] += 2 * settings_.stiffness;
    for (std::size_t p = 0; p < mass.size(); ++p)
        if (mass[p] > 0) frequencySquared_ = std::max(frequencySquared_, rows[p] / mass[p]);
}

double SeamClosing::durationOf(double initialGap, const SeamClosingSettings& settings) {
    return std::max(settings.duration,
                    1.5 * initialGap / settings.maximumSpeed); // speed is 1.5 · gap / duration at most
}

double SeamClosing::allowedGap(const SeamPair& pair, double time, const SeamClosingSettings& settings) {
    const double s = std::clamp((time - pair.startTime) / durationOf(pair.initialGap, settings), 0.0, 1.0);
    return pair.initialGap * (1 - s * s * (3 - 2 * s));
}

void SeamClosing::project(dynamics::Substep& substep) {
    for (int iteration = 0; iteration < settings_.iterations; ++iteration)
        for (const SeamPair& pair : pairs_) {
            const double wa = substep.inverseMass[pair.a], wb = substep.inverseMass[pair.b];
            const Vec3 apart = substep.positions[pair.b] - substep.positions[pair.a];
            const double gap = length(apart), excess = gap - allowedGap(pair, substep.time, settings_);
            if (excess <= 0 || wa + wb <= 0) continue;
            const double limit = settings_.maximumForce * substep.duration * substep.duration * (wa + wb);
            const Vec3 correction = apart * (std::min(excess, limit) / (gap * (wa + wb)));
            substep.positions[pair.a] += correction * wa;
            substep.positions[pair.b] -= correction * wb;
        }
}

void SeamClosing::beginStep(const dynamics::ParticleState& state, double duration) {
    time_ = state.time + duration;
}

double SeamClosing::share(const SeamPair& pair) const {
    if (settings_.forceRamp <= 0) return 1;
    return std::clamp((time_ - pair.startTime) / settings_.forceRamp, 0.0, 1.0);
}

double SeamClosing::energy(std::span<const Vec3> positions) const {
    const double yields = settings_.maximumForce / settings_.stiffness; // from this gap on the force is constant
    double sum = 0;
    for (const SeamPair& pair : pairs_) {
        const double gap = geometry::distance(positions[pair.a], positions[pair.b]);
        sum += share(pair) *
               (gap <= yields ? 0.5 * settings_.stiffness * gap * gap : settings_.maximumForce * (gap - 0.5 * yields));
    }
    return sum;
}

void SeamClosing::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    for (const SeamPair& pair : pairs_) {
        const Vec3 apart = positions[pair.b] - positions[pair.a];
        const double gap = length(apart);
        const bool yields = gap * settings_.stiffness > settings_.maximumForce;
        const Vec3 pull = apart * (share(pair) * (yields ? settings_.maximumForce / gap : settings_.stiffness));
        forces[pair.a] += pull;
        forces[pair.b] -= pull;
    }
}

void SeamClosing::addHessian(std::span<const Vec3> positions, dynamics::HessianSink& sink) const {
    for (const SeamPair& pair : pairs_) {
        const Vec3 apart = positions[pair.b] - positions[pair.a];
        const double gap = length(apart);
        const bool yields = gap * settings_.stiffness > settings_.maximumForce;
        const double across = share(pair) * (yields ? settings_.maximumForce / gap : settings_.stiffness);
        const Vec3 n = yields ? apart / gap : Vec3{}; // along a constant force there is no stiffness
        double same[9], other[9];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                same[3 * i + j] = across * ((i == j ? 1 : 0) - n[i] * n[j]);
                other[3 * i + j] = -same[3 * i + j];
            }
        sink.add(pair.a, pair.a, same);
        sink.add(pair.b, pair.b, same);
        sink.add(pair.a, pair.b, other);
        sink.add(pair.b, pair.a, other);
    }
}

} // namespace toile::simulation
