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
using collision::stayApart;

/// Less is no force [N]: a thousandth of the weight of 10 mm² of light cloth.
constexpr double leastForce = 1e-8;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double distanceRounding = 1e-12; // [m]

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

/// How much of the potential of a pair counts [–], and the derivative of that by its vertices [1/m].
struct Share {
    double value = 1;
    std::array<Vec3, 4> slope{};
};

/// The nearest points of edges leap from end to end where these become parallel, and with them the force: a fold there
/// is no equilibrium that Newton could find. Pairs of edges therefore fade out below an angle of 2°; corners and
/// triangles hold such layers apart. Ref: Li et al. 2020, §4.3
Share shareOf(const collision::ElementPair& pair, std::span<const Vec3> positions) {
    constexpr double whole = 1e-3; // sin² of the angle
    if (pair.firstCount == 1) return {};
    const auto& v = pair.vertices;
    const Vec3 a = positions[v[1]] - positions[v[0]], b = positions[v[3]] - positions[v[2]];
    const double aa = squaredLength(a), bb = squaredLength(b), ab = dot(a, b);
    if (!(aa > 0 && bb > 0)) return {.value = 0};
    const double s = std::max(0.0, 1 - ab * ab / (aa * bb));
    if (s >= whole) return {};
    const double part = s / whole, slope = 2 * (1 - part) / whole;
    const Vec3 byA = (2 * slope * ab / (aa * bb)) * ((ab / aa) * a - b),
               byB = (2 * slope * ab / (aa * bb)) * ((ab / bb) * b - a);
    return {part * (2 - part), {-byA, byA, -byB, byB}};
}

} // namespace

/// Pairs beyond the reach need four moves to meet; neighbours are sought again after the first of a particle's two.
void SelfContact::keepNeighbours(std::span<const Vec3> positions) {
    const bool first = anchors_.empty();
    if (first) {
        anchors_.assign(positions.begin(), positions.end());
        mayPierce_ = true; // who calls may have come here by ways that nobody held
    }
    if (first || from_.size() != positions.size() || farthestMove(from_, positions) > staticMove_)
        seekForStatics(positions);
}

/// The first after position-based substeps takes their mean: the potential may be far from balance there.
void SelfContact::fixFriction(std::span<const Vec3> positions) {
    const bool first = anchors_.empty();
    keepNeighbours(positions);
    normalForceBefore_.clear();
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        const Watch& watch = watches_[i];
        Contact& contact = contacts_[i];
        normalForceBefore_.push_back(contact.normalForce);
        const bool touches = leastDistance(watch, positions) < watch.target;
        if (touches || contact.normalForce > 0) look(watch, contact, positions);
        if (!first)
            contact.normalForce = touches && contact.start > noDistance
                                      ? shareOf(watch.elements, positions).value * pressureAt(watch, contact.start)
                                      : 0;
    }
    listRubbing();
}

void SelfContact::easeFriction(double part) {
    for (std::size_t i = 0; i < contacts_.size(); ++i)
        contacts_[i].normalForce = std::lerp(normalForceBefore_[i], contacts_[i].normalForce, part);
    listRubbing();
}

void SelfContact::listRubbing() {
    rubbing_.clear();
    for (std::size_t i = 0; i < watches_.size(); ++i)
        if (const Contact& contact = contacts_[i]; contact.normalForce >= leastForce && contact.start > noDistance)
            rubbing_.push_back({watches_[i].elements.vertices, contact.weights, contact.direction,
                                contact.friction * contact.normalForce});
}

void SelfContact::beginIteration(std::span<const Vec3> positions) {
    keepNeighbours(positions);
    iterationStart_.assign(positions.begin(), positions.end());
    moves_.clear();
    coming_.clear();
    isComingKnown_ = true;
    for (std::size_t i = 0; i < watches_.size(); ++i)
        if (const double beyond = leastDistance(watches_[i], positions) - watches_[i].target;
            beyond <= 2 * staticMove_) {
            look(watches_[i], contacts_[i], positions);
            coming_.push_back({i, beyond});
        }
}

/// visit(watch, contact) for the pairs of which something may be felt. Those that are farther beyond their target than
/// both ends have moved since the iteration began are not even looked at.
template <class Visit>
void SelfContact::forPressed(std::span<const Vec3> positions, const Visit& visit) const {
    const auto see = [&](std::size_t i) {
        if (!isFar(watches_[i], contacts_[i], positions)) visit(watches_[i], contacts_[i]);
    };
    const double moved = isComingKnown_ ? farthestMove(iterationStart_, positions) : infinity;
    if (moved <= staticMove_) {
        for (const Coming& coming : coming_)
            if (coming.distance <= 2 * moved + distanceRounding) see(coming.pair);
    } else {
        for (std::size_t i = 0; i < watches_.size(); ++i) see(i);
    }
}

/// Where pairs would be too many, particles may move by less.
void SelfContact::seekForStatics(std::span<const Vec3> positions) {
    prepareSearch(positions);
    for (ahead_ = std::min(1.0, 2 * ahead_); ahead_ >= leastAhead; ahead_ *= 0.5) {
        staticMove_ = ahead_ * mostStaticMove_;
        if (watch(proximity_->pairsWithin(4 * staticMove_ + thickest_, positions, settings_.mostPairs), positions))
            return;
    }
    staticMove_ = 0;
    static_cast<void>(watch(std::vector<collision::SelfProximity::Near>{}, positions));
}

double SelfContact::energy(std::span<const Vec3> positions) const {
    if (farthestMove(iterationStart_, positions) > staticMove_) return infinity;
    double sum = 0;
    forPressed(positions, [&](const Watch& watch, const Contact& contact) {
        const double kept = justEnough * keptOf(contact.start, settings_.staticClosest);
        if (gapAlong(contact.direction, watch.elements, positions) < kept &&
            !stayApart(watch.elements, iterationStart_, positions, kept))
            sum = infinity;
        if (sum == infinity) return;
        const double distance = separationOf(watch.elements, positions).distance;
        sum += shareOf(watch.elements, positions).value * storedAt(watch, distance);
    });
    if (sum == infinity) return infinity;
    for (const Rubbing& pair : rubbing_)
        sum += pair.force * smoothLength(length(slipOf(pair, positions)), settings_.frictionGive);
    return sum;
}

void SelfContact::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    forPressed(positions, [&](const Watch& watch, const Contact&) {
        const auto& v = watch.elements.vertices;
        const Separation found = separationOf(watch.elements, positions);
        if (found.distance < watch.target && found.distance > noDistance) {
            const Share share = shareOf(watch.elements, positions);
            const Vec3 force = found.way * (share.value * pressureAt(watch, found.distance) / found.distance);
            const double stored = storedAt(watch, found.distance);
            for (int k = 0; k < 4; ++k) forces[v[k]] += found.weights[k] * force - stored * share.slope[k];
        }
    });
    for (const Rubbing& pair : rubbing_) {
        const Vec3 slip = slipOf(pair, positions);
        const double drag = pair.force * smoothSlopeOverLength(length(slip), settings_.frictionGive);
        for (int k = 0; k < 4; ++k) forces[pair.vertices[k]] -= (pair.weights[k] * drag) * slip;
    }
}

void SelfContact::addHessian(std::span<const Vec3> positions, HessianSink& sink) const {
    const auto add = [&](const std::array<int, 4>& v, const std::array<double, 4>& weights, const double(&whole)[9]) {
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 4; ++k) {
                double block[9];
                for (int e = 0; e < 9; ++e) block[e] = weights[i] * weights[k] * whole[e];
                sink.add(v[i], v[k], block);
            }
    };
    forPressed(positions, [&](const Watch& watch, const Contact&) {
        const Separation found = separationOf(watch.elements, positions);
        if (found.distance < watch.target && found.distance > noDistance) {
            double pressed[9] = {};
            addOuter(pressed, found.way / found.distance,
                     shareOf(watch.elements, positions).value * stiffnessOf(watch) *
                         barrierCurvature(found.distance / watch.target));
            add(watch.elements.vertices, found.weights, pressed);
        }
    });
    for (const Rubbing& pair : rubbing_) {
        double rubbed[9] = {};
        addFrictionCurvature(rubbed, slipOf(pair, positions), pair.direction, pair.force, settings_.frictionGive);
        add(pair.vertices, pair.weights, rubbed);
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
    return leastDistance(watch, positions) > watch.target || contact.start <= noDistance;
}

double SelfContact::stiffnessOf(const Watch& watch) const {
    const auto& v = watch.elements.vertices;
    return settings_.stiffness * 0.25 * (mass_[v[0]] + mass_[v[1]] + mass_[v[2]] + mass_[v[3]]);
}

/// In a pair at a distance [J].
double SelfContact::storedAt(const Watch& watch, double distance) const {
    return stiffnessOf(watch) * watch.target * watch.target * barrier(distance / watch.target);
}

/// With which a pair at a distance is pushed apart [N].
double SelfContact::pressureAt(const Watch& watch, double distance) const {
    return -stiffnessOf(watch) * watch.target * barrierSlope(distance / watch.target);
}

Vec3 SelfContact::slipOf(const Rubbing& pair, std::span<const Vec3> positions) const {
    Vec3 slip;
    for (int i = 0; i < 4; ++i) slip += pair.weights[i] * (positions[pair.vertices[i]] - anchors_[pair.vertices[i]]);
    return tangential(slip, pair.direction);
}

} // namespace toile::dynamics
