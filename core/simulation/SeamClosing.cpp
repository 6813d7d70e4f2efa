// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SeamClosing.h"

#include <algorithm>
#include <cmath>

namespace toile::simulation {

SeamClosing::SeamClosing(std::vector<SeamPair> pairs, SeamClosingSettings settings)
    : pairs_(std::move(pairs)), settings_(settings) {}

double SeamClosing::allowedGap(const SeamPair& pair, double time, const SeamClosingSettings& settings) {
    const double duration = std::max(settings.duration, 1.5 * pair.initialGap / settings.maximumSpeed);
    const double s = std::clamp((time - pair.startTime) / duration, 0.0, 1.0);
    return pair.initialGap * (1 - s * s * (3 - 2 * s)); // largest speed is 1.5 · gap / duration
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

double SeamClosing::energy(std::span<const Vec3> positions) const {
    double sum = 0;
    for (const SeamPair& pair : pairs_)
        sum += 0.5 * settings_.staticStiffness * squaredLength(positions[pair.b] - positions[pair.a]);
    return sum;
}

void SeamClosing::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    for (const SeamPair& pair : pairs_) {
        const Vec3 pull = (positions[pair.b] - positions[pair.a]) * settings_.staticStiffness;
        forces[pair.a] += pull;
        forces[pair.b] -= pull;
    }
}

void SeamClosing::addHessian(std::span<const Vec3>, dynamics::HessianSink& sink) const {
    const double k = settings_.staticStiffness;
    const double same[9] = {k, 0, 0, 0, k, 0, 0, 0, k}, other[9] = {-k, 0, 0, 0, -k, 0, 0, 0, -k};
    for (const SeamPair& pair : pairs_) {
        sink.add(pair.a, pair.a, same);
        sink.add(pair.b, pair.b, same);
        sink.add(pair.a, pair.b, other);
        sink.add(pair.b, pair.a, other);
    }
}

} // namespace toile::simulation
