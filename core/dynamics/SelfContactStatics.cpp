// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include "core/dynamics/Friction.h"

#include <algorithm>
#include <cmath>
#include <limits>

/// Self-contact as a potential for Newton's method.
namespace toile::dynamics {
namespace {

using collision::gapAlong;
using collision::Separation;
using collision::separationOf;

/// Friction of one iteration rests on at least this part of the normal force of the iteration before [–].
constexpr double keptNormalForce = 0.5;
/// Less is no force [N]: a thousandth of the weight of 10 mm² of light cloth.
constexpr double leastForce = 1e-8;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The potential of statics over s = distance / target in (0, 1): −(1 − s)² ln s. Soft where layers begin to
/// touch, without a jump in its curvature, and infinite where they meet. Ref: Li et al. 2020, §4.
double barrier(double s) {
    return s < 1 ? -(1 - s) * (1 - s) * std::log(s) : 0;
}
double barrierSlope(double s) {
    return s < 1 ? (1 - s) * (2 * std::log(s) - (1 - s) / s) : 0;
}
double barrierCurvature(double s) {
    return s < 1 ? (1 - s) * (4 / s + (1 - s) / (s * s)) - 2 * std::log(s) : 0;
}

} // namespace

void SelfContact::beginIteration(std::span<const Vec3> positions) {
    const bool first = anchors_.empty();
    if (first) {
        anchors_.assign(positions.begin(), positions.end());
        mayPierce_ = true; // who calls may have come here by ways that nobody held
    }
    // Pairs beyond the reach need four moves to meet; neighbours are sought again after the first of a
    // particle's two.
    if (first || farthestMove(from_, positions) > staticMove_) seekForStatics(positions);
    iterationStart_.assign(positions.begin(), positions.end());
    moves_.clear();
    ++substep_;
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        const Watch& watch = watches_[i];
        Contact& contact = contacts_[i];
        double force = 0;
        if (leastDistance(watch, positions) < watch.target + 2 * staticMove_) {
            look(watch, contact, positions);
            if (contact.start > noDistance) force = pressureAt(watch, contact.start);
        }
        contact.normalForce = std::max(contact.normalForce * (first ? 1 : keptNormalForce), force);
        if (contact.normalForce < leastForce) contact.normalForce = 0;
    }
}

/// Where pairs would be too many, particles may move by less.
void SelfContact::seekForStatics(std::span<const Vec3> positions) {
    prepareSearch(positions);
    for (ahead_ = std::min(1.0, 2 * ahead_); ahead_ >= leastAhead; ahead_ *= 0.5) {
        staticMove_ = ahead_ * settings_.staticMove;
        if (watch(proximity_->pairsWithin(4 * staticMove_ + thickest_, positions, settings_.mostPairs), positions))
            return;
    }
    staticMove_ = 0;
    watches_.clear();
    contacts_.clear();
    from_.assign(positions.begin(), positions.end());
}

double SelfContact::energy(std::span<const Vec3> positions) const {
    if (farthestMove(iterationStart_, positions) > staticMove_) return infinity;
    double sum = 0;
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        const Watch& watch = watches_[i];
        const Contact& contact = contacts_[i];
        if (isFar(watch, contact, positions)) continue;
        if (gapAlong(contact.direction, watch.elements, positions) < justEnough * keptOf(contact.start))
            return infinity;
        const double distance = separationOf(watch.elements, positions).distance;
        sum += stiffnessOf(watch) * watch.target * watch.target * barrier(distance / watch.target);
        if (contact.normalForce > 0)
            sum += contact.friction * contact.normalForce *
                   smoothLength(length(slipOf(i, positions)), settings_.frictionGive);
    }
    return sum;
}

void SelfContact::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        const Watch& watch = watches_[i];
        const Contact& contact = contacts_[i];
        if (isFar(watch, contact, positions)) continue;
        const auto& v = watch.elements.vertices;
        const Separation found = separationOf(watch.elements, positions);
        if (found.distance < watch.target && found.distance > noDistance) {
            const Vec3 force = found.way * (pressureAt(watch, found.distance) / found.distance);
            for (int k = 0; k < 4; ++k) forces[v[k]] += found.weights[k] * force;
        }
        if (contact.normalForce == 0) continue;
        const Vec3 slip = slipOf(i, positions);
        const double drag =
            contact.friction * contact.normalForce * smoothSlopeOverLength(length(slip), settings_.frictionGive);
        for (int k = 0; k < 4; ++k) forces[v[k]] -= (contact.weights[k] * drag) * slip;
    }
}

void SelfContact::addHessian(std::span<const Vec3> positions, HessianSink& sink) const {
    const auto add = [&](const Watch& watch, const std::array<double, 4>& weights, const double(&whole)[9]) {
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) {
                double block[9];
                for (int e = 0; e < 9; ++e) block[e] = weights[i] * weights[k] * whole[e];
                sink.add(watch.elements.vertices[i], watch.elements.vertices[k], block);
            }
    };
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        const Watch& watch = watches_[i];
        const Contact& contact = contacts_[i];
        if (isFar(watch, contact, positions)) continue;
        const Separation found = separationOf(watch.elements, positions);
        if (found.distance < watch.target && found.distance > noDistance) {
            double pressed[9] = {};
            addOuter(pressed, found.way / found.distance,
                     stiffnessOf(watch) * barrierCurvature(found.distance / watch.target));
            add(watch, found.weights, pressed);
        }
        if (contact.normalForce == 0) continue;
        double rubbed[9] = {};
        addFrictionCurvature(rubbed, slipOf(i, positions), contact.direction, contact.friction * contact.normalForce,
                             settings_.frictionGive);
        add(watch, contact.weights, rubbed);
    }
}

/// For layers pressed to half their thickness, where each particle is in as many pairs as on a sheet that
/// lies on another.
double SelfContact::largestFrequencySquared() const {
    constexpr double pairs = 12;
    return pairs * settings_.stiffness * barrierCurvature(0.5);
}

/// Nothing is to be felt of this pair, and it cannot cross.
bool SelfContact::isFar(const Watch& watch, const Contact& contact, std::span<const Vec3> positions) const {
    if (contact.normalForce > 0) return contact.start <= noDistance;
    return leastDistance(watch, positions) > watch.target || contact.start <= noDistance;
}

double SelfContact::stiffnessOf(const Watch& watch) const {
    const auto& v = watch.elements.vertices;
    return settings_.stiffness * 0.25 * (mass_[v[0]] + mass_[v[1]] + mass_[v[2]] + mass_[v[3]]);
}

/// With which a pair at a distance is pushed apart [N].
double SelfContact::pressureAt(const Watch& watch, double distance) const {
    return -stiffnessOf(watch) * watch.target * barrierSlope(distance / watch.target);
}

Vec3 SelfContact::slipOf(std::size_t pair, std::span<const Vec3> positions) const {
    Vec3 slip;
    for (int i = 0; i < 4; ++i) {
        const int p = watches_[pair].elements.vertices[i];
        slip += contacts_[pair].weights[i] * (positions[p] - anchors_[p]);
    }
    return tangential(slip, contacts_[pair].direction);
}

} // namespace toile::dynamics
