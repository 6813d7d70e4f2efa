// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/StrainDamping.h"

#include "core/cloth/Forces.h"

#include <algorithm>
#include <cmath>

namespace toile::dynamics {

namespace {

/// What damping adds to the bound ω² of undamped cloth, for steps that end at h·ω = 2: with it they end at
/// h·ω = 2(√(1 + ζ²) − ζ).
double addedBy(double time, double squared) {
    const double ratio = time * std::sqrt(squared) / 2, longer = std::sqrt(1 + ratio * ratio) + ratio;
    return squared * (longer * longer - 1);
}

} // namespace

StrainDamping::StrainDamping(const cloth::ClothModel& model, double time, std::span<const Vec3> positions)
    : model_(model), time_(time), frequencySquared_(addedBy(time, cloth::largestFrequencySquared(model, positions))) {
    cloth::strainGradients(model, positions, strains_); // what they hold from now on
}

void StrainDamping::project(Substep& substep) {
    const double h = substep.duration;
    cloth::strainGradients(model_, substep.positions, strains_);
    for (const cloth::StrainGradient& strain : strains_) {
        double way = 0, mobility = 0;
        for (int i = 0; i < 4; ++i) {
            const int p = strain.particles[i];
            if (p < 0) continue;
            way += dot(strain.gradient[i], substep.positions[p] - substep.previous[p]);
            mobility += substep.inverseMass[p] * squaredLength(strain.gradient[i]);
        }
        if (mobility == 0 || way == 0) continue;
        const double resisted = h * time_ * strain.stiffness * mobility;
        const double back = way * resisted / (1 + resisted) / mobility;
        for (int i = 0; i < 4; ++i)
            if (const int p = strain.particles[i]; p >= 0)
                substep.positions[p] -= (back * substep.inverseMass[p]) * strain.gradient[i];
    }
}

void StrainDamping::fixFriction(std::span<const Vec3> positions) {
    const bool rests = motion_.velocities.empty() && motion_.from.empty();
    if (rests) strains_.clear();
    else cloth::strainGradients(model_, positions, strains_);
}

/// ṡ of who is at these positions.
double StrainDamping::rateOf(const cloth::StrainGradient& strain, std::span<const Vec3> positions) const {
    double rate = 0;
    for (int i = 0; i < 4; ++i) {
        const int p = strain.particles[i];
        if (p < 0) continue;
        rate += dot(strain.gradient[i],
                    motion_.from.empty() ? motion_.velocities[p] : (positions[p] - motion_.from[p]) / motion_.span);
    }
    return rate;
}

double StrainDamping::energy(std::span<const Vec3> positions) const {
    if (motion_.from.empty()) return 0;
    double sum = 0;
    for (const cloth::StrainGradient& strain : strains_) {
        const double rate = rateOf(strain, positions);
        sum += 0.5 * time_ * strain.stiffness * rate * rate * motion_.span;
    }
    return sum;
}

void StrainDamping::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    for (const cloth::StrainGradient& strain : strains_) {
        const double tension = time_ * strain.stiffness * rateOf(strain, positions);
        for (int i = 0; i < 4; ++i)
            if (const int p = strain.particles[i]; p >= 0) forces[p] -= tension * strain.gradient[i];
    }
}

void StrainDamping::addHessian(std::span<const Vec3>, HessianSink& sink) const {
    if (motion_.from.empty()) return; // a given force
    for (const cloth::StrainGradient& strain : strains_) {
        const double stiffness = time_ * strain.stiffness / motion_.span;
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                const int p = strain.particles[i], q = strain.particles[j];
                if (p < 0 || q < 0) continue;
                double block[9];
                for (int a = 0; a < 3; ++a)
                    for (int b = 0; b < 3; ++b)
                        block[3 * a + b] = stiffness * strain.gradient[i][a] * strain.gradient[j][b];
                sink.add(p, q, block);
            }
    }
}

} // namespace toile::dynamics
