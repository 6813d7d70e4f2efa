// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include "core/base/Contracts.h"
#include "core/dynamics/Friction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace toile::dynamics {
namespace {

using collision::ElementPair;
using collision::gapAlong;
using collision::Separation;
using collision::separationOf;

/// Within which the normal force of the substeps is averaged [s].
constexpr double forceMemory = 1.0 / 60;
/// Friction of one iteration rests on at least this part of the normal force of the iteration before [–].
constexpr double keptNormalForce = 0.5;
/// Elements nearer than this have no direction that could be trusted: they count as crossed [m].
constexpr double noDistance = 1e-9;
/// Part of the distance at rest that compressed cloth may fall to before its own parts push each other [–].
constexpr double usedRoom = 0.5;

/// Of what is to be kept, so that rounding does not ask for more [–].
constexpr double justEnough = 0.99;
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

double farthestMove(std::span<const Vec3> from, std::span<const Vec3> to) {
    double squared = 0;
    for (std::size_t p = 0; p < to.size(); ++p) squared = std::max(squared, squaredLength(to[p] - from[p]));
    return std::sqrt(squared);
}

} // namespace

SelfContact::SelfContact(const cloth::ClothModel& model, ClothSurface surface, SelfContactSettings settings)
    : model_(model), surface_(std::move(surface)), settings_(settings), mass_(model.mass),
      slaveOf_(model.mass.size(), -1) {
    const std::size_t count = model.mass.size();
    expects(surface_.halfThickness.size() == count && surface_.friction.size() == count &&
                surface_.room.size() == count,
            "one value per particle");
    expects(surface_.ignored.empty() || surface_.ignored.size() == count, "one list per particle, or none");
    for (std::size_t s = 0; s < model.slaves.size(); ++s) {
        const cloth::Slave& slave = model.slaves[s];
        slaveOf_[slave.particle] = static_cast<int>(s);
        mass_[slave.particle] = 0;
        for (const auto& [master, weight] : slave.masters) mass_[slave.particle] += weight * model.mass[master];
    }
    for (const double half : surface_.halfThickness) thickest_ = std::max(thickest_, 2 * half);
}

std::size_t SelfContact::bytes() const {
    const std::size_t vectors =
        from_.capacity() + moves_.capacity() + wanted_.capacity() + anchors_.capacity() + iterationStart_.capacity();
    return vectors * sizeof(Vec3) + watches_.capacity() * sizeof(Watch) + contacts_.capacity() * sizeof(Contact) +
           (proximity_ ? proximity_->bytes() : 0);
}

// ---- Which pairs are near
// -------------------------------------------------------------------------------------------

void SelfContact::beginStep(const ParticleState&, double duration) {
    frame_ = duration;
    if (mayPierce_ || !anchors_.empty()) from_.clear(); // layers cross, or statics has been at work: look again
    anchors_.clear();
}

double SelfContact::targetOf(const ElementPair& pair) const {
    const auto& v = pair.vertices;
    const auto half = [&](int i) { return surface_.halfThickness[v[i]]; };
    double room = infinity;
    if (pair.firstCount == 1) room = surface_.room[v[0]];
    else
        for (const int p : v) room = std::min(room, surface_.room[p]);
    const double thickness = pair.firstCount == 1 ? half(0) + std::max({half(1), half(2), half(3)})
                                                  : std::max(half(0), half(1)) + std::max(half(2), half(3));
    return std::min(thickness, usedRoom * room);
}

SelfContact::Contact SelfContact::contactOf(const ElementPair& pair) const {
    double first = 0, second = 0;
    for (int i = 0; i < 4; ++i) {
        double& friction = i < pair.firstCount ? first : second;
        friction = std::max(friction, surface_.friction[pair.vertices[i]]);
    }
    Contact contact;
    contact.friction = std::sqrt(first * second);
    return contact;
}

bool SelfContact::isIgnored(const ElementPair& pair) const {
    if (surface_.ignored.empty()) return false;
    for (int i = 0; i < pair.firstCount; ++i)
        for (int k = pair.firstCount; k < 4; ++k)
            if (std::ranges::binary_search(surface_.ignored[pair.vertices[i]], pair.vertices[k])) return true;
    return false;
}

void SelfContact::search(double reach, std::span<const Vec3> positions, std::span<const Vec3> moves) {
    if (!proximity_) proximity_.emplace(surface_.triangles, positions);
    if (mayPierce_) seekPiercings(positions);
    std::vector<char> crossed(positions.size(), 0);
    for (const auto& [edge, triangle] : piercings_) {
        for (const int p : proximity_->edges()[edge].vertices) crossed[p] = 1;
        for (const int p : proximity_->triangles()[triangle]) crossed[p] = 1;
    }
    std::map<ElementPair, double> pressed;
    for (std::size_t i = 0; i < watches_.size(); ++i)
        if (contacts_[i].normalForce > 0) pressed.emplace(watches_[i].elements, contacts_[i].normalForce);

    watches_.clear();
    contacts_.clear();
    for (const auto& [pair, distance] : proximity_->pairsWithin(reach, positions, moves)) {
        if (std::ranges::all_of(pair.vertices, [&](int p) { return crossed[p]; }) || isIgnored(pair)) continue;
        watches_.push_back({pair, targetOf(pair), distance, distance, distance});
        contacts_.push_back(contactOf(pair));
        if (const auto known = pressed.find(pair); known != pressed.end()) contacts_.back().normalForce = known->second;
    }
    from_.assign(positions.begin(), positions.end());
    ++searches_;
}

void SelfContact::seekPiercings(std::span<const Vec3> positions) {
    piercings_ = proximity_->piercings(positions);
    std::erase_if(piercings_, [&](const collision::Piercing& piercing) {
        const auto& [p, q] = proximity_->edges()[piercing.edge].vertices;
        const auto& [a, b, c] = proximity_->triangles()[piercing.triangle];
        return isIgnored({{p, a, b, c}, 1}) || isIgnored({{q, a, b, c}, 1});
    });
    mayPierce_ = !piercings_.empty();
}

std::vector<Vec3> SelfContact::crossingPlaces(std::span<const Vec3> positions) const {
    std::vector<Vec3> places;
    for (const auto& [edge, triangle] : piercings_) {
        const auto& [p, q] = proximity_->edges()[edge].vertices;
        places.push_back(lerp(positions[p], positions[q], 0.5));
    }
    return places;
}

/// Whether every particle is near the way that was foreseen when neighbours were sought.
bool SelfContact::foreseen(std::span<const Vec3> positions, double time) const {
    if (from_.size() != positions.size()) return false;
    const double done = std::clamp((time - fromTime_) / horizon_, 0.0, 1.0),
                 squared = settings_.slack * settings_.slack;
    for (std::size_t p = 0; p < positions.size(); ++p)
        if (squaredLength(positions[p] - from_[p] - done * moves_[p]) > squared) return false;
    return true;
}

/// Seeks neighbours for one frame step ahead, as if particles went on as in this substep.
void SelfContact::foresee(const Substep& substep) {
    horizon_ = std::max(frame_, substep.duration);
    fromTime_ = substep.time - substep.duration;
    moves_.resize(substep.positions.size());
    for (std::size_t p = 0; p < moves_.size(); ++p)
        moves_[p] = (horizon_ / substep.duration) * (substep.positions[p] - substep.previous[p]);
    search(2 * settings_.slack + thickest_, substep.previous, moves_);
}

/// By what its ends have moved against each other since neighbours were sought.
double SelfContact::leastDistance(const Watch& watch, std::span<const Vec3> positions) const {
    const auto& v = watch.elements.vertices;
    const auto moved = [&](int i) { return positions[v[i]] - from_[v[i]]; };
    const Vec3 a = moved(0), b = moved(1), c = moved(2), d = moved(3);
    const double squared =
        watch.elements.firstCount == 1
            ? std::max({squaredLength(a - b), squaredLength(a - c), squaredLength(a - d)})
            : std::max({squaredLength(a - c), squaredLength(a - d), squaredLength(b - c), squaredLength(b - d)});
    return watch.known - std::sqrt(squared);
}

/// Finds the direction and the weights of the shortest way at some positions.
void SelfContact::look(const Watch& watch, Contact& contact, std::span<const Vec3> positions) const {
    const Separation found = separationOf(watch.elements, positions);
    contact.substep = substep_;
    contact.start = found.distance;
    contact.direction = found.distance > noDistance ? found.way / found.distance : Vec3{};
    contact.weights = found.weights;
}

// ---- A substep
// ------------------------------------------------------------------------------------------------------

void SelfContact::project(Substep& substep) {
    anchors_.clear();
    ++substep_;
    if (!foreseen(substep.positions, substep.time)) foresee(substep);
    pushApart(substep);
    uncross(substep);
    placeSlaves(substep.positions);
    holdApart(substep);
    if (foreseen(substep.positions, substep.time)) return;

    // What was pushed or held has left the ways foreseen. This list holds whatever part of its way each one
    // goes.
    const double farthest = farthestMove(substep.previous, substep.positions);
    moves_.assign(moves_.size(), Vec3{});
    fromTime_ = substep.time - substep.duration;
    search(2 * (farthest + settings_.slack) + thickest_, substep.previous, {});
    holdApart(substep);
}

/// Layers that would come nearer than their thickness are lifted to it.
void SelfContact::pushApart(Substep& substep) {
    touching_.clear();
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        Watch& watch = watches_[i];
        watch.before = watch.now;
        watch.now = leastDistance(watch, substep.positions);
        if (watch.now > watch.target && watch.before > 0) continue;
        Contact& contact = contacts_[i];
        if (gapAlong(contact.direction, watch.elements, substep.positions) > watch.target) continue;
        if (meetsOnTheWay(watch, contact, substep)) touching_.push_back(i);
    }
    for (int sweep = 0; sweep < settings_.sweeps; ++sweep) {
        for (const std::size_t i : touching_) push(watches_[i], contacts_[i], substep);
        if (!model_.slaves.empty()) placeSlaves(substep.positions);
    }
}

/// The shortest way at the end of the substep counts, if along it they were clearly on the same sides at its
/// start: layers that slide past each other do not bump into each other's edges. Else they would cross, and
/// that at the start counts.
bool SelfContact::meetsOnTheWay(const Watch& watch, Contact& contact, const Substep& substep) const {
    constexpr double clearly = 0.1; // of the distance
    look(watch, contact, substep.positions);
    const Contact end = contact;
    look(watch, contact, substep.previous);
    if (contact.start <= noDistance) return false;
    if (end.start <= noDistance || gapAlong(end.direction, watch.elements, substep.previous) < clearly * contact.start)
        return true;
    contact.direction = end.direction;
    contact.weights = end.weights;
    return end.start < watch.target;
}

void SelfContact::push(const Watch& watch, Contact& contact, Substep& substep) const {
    const auto& v = watch.elements.vertices;
    Vec3 way, slip;
    double mobility = 0; // [1/kg]
    for (int i = 0; i < 4; ++i) {
        way += contact.weights[i] * substep.positions[v[i]];
        slip += contact.weights[i] * (substep.positions[v[i]] - substep.previous[v[i]]);
        mobility += contact.weights[i] * contact.weights[i] * substep.inverseMass[v[i]];
    }
    const double allowed =
        allowedDistance(contact.start, watch.target, substep.duration, settings_.pushOutTime, settings_.pushOutSpeed);
    const double lift = allowed - dot(way, contact.direction);
    if (lift <= 0 || mobility == 0) return;
    Vec3 correction = contact.direction * lift;
    slip = tangential(slip, contact.direction);
    const double slipped = length(slip);
    if (slipped > 0) correction -= slip * std::min(1.0, contact.friction * lift / slipped);
    for (int i = 0; i < 4; ++i)
        move(v[i], correction * (contact.weights[i] * substep.inverseMass[v[i]] / mobility), substep);
    const double force = lift / (mobility * substep.duration * substep.duration);
    contact.normalForce -= std::expm1(-substep.duration / forceMemory) * (force - contact.normalForce);
}

/// A slave goes by moving its masters, by the least weighted motion that takes it there.
void SelfContact::move(int particle, const Vec3& by, Substep& substep) const {
    if (slaveOf_[particle] < 0) {
        substep.positions[particle] += by;
        return;
    }
    const double mobility = substep.inverseMass[particle]; // Σ w²/m
    if (mobility == 0) return;
    for (const auto& [master, weight] : model_.slaves[slaveOf_[particle]].masters)
        substep.positions[master] += by * (weight * substep.inverseMass[master] / mobility);
}

/// The same sum, term by term, as the integrator makes: what it reads back is no move.
void SelfContact::placeSlave(int slave, std::span<Vec3> positions) const {
    Vec3 place;
    for (const auto& [master, weight] : model_.slaves[slave].masters) place += weight * positions[master];
    positions[model_.slaves[slave].particle] = place;
}

void SelfContact::placeSlaves(std::span<Vec3> positions) const {
    for (int s = 0; s < static_cast<int>(model_.slaves.size()); ++s) placeSlave(s, positions);
}

/// Draws edges out of triangles they pass through: each pair goes apart the way that shortens the line along
/// which the layers meet. Ref: Volino & Magnenat-Thalmann 2006, Resolving Surface Collisions through
/// Intersection Contour Minimization
void SelfContact::uncross(Substep& substep) const {
    const auto& x = substep.positions;
    for (const auto& [edge, triangle] : piercings_) {
        const auto& [p, q] = proximity_->edges()[edge].vertices;
        const auto& corners = proximity_->triangles()[triangle];
        const Vec3 &a = x[corners[0]], &b = x[corners[1]], &c = x[corners[2]];
        if (!collision::segmentPierces(x[p], x[q], a, b, c)) continue;
        const Vec3 normal = normalized(cross(b - a, c - a)), along = normalized(x[q] - x[p]);
        const double steepness = dot(along, normal);
        Vec3 shortening; // where the edge should go
        for (const int across : proximity_->edges()[edge].opposite) {
            if (across < 0) continue;
            const Vec3 inward = x[across] - x[p], faceNormal = cross(x[q] - x[p], inward);
            Vec3 line = cross(normal, faceNormal);
            const double size = length(line);
            if (size == 0) continue;
            line = line / (dot(line, inward - along * dot(inward, along)) > 0 ? size : -size);
            shortening += line - normal * (dot(along, line) / steepness);
        }
        const double size = length(shortening);
        if (!(size > 1e-6) || !std::isfinite(size)) continue; // the line would not become shorter
        const double t = dot(normal, a - x[p]) / dot(normal, x[q] - x[p]);
        const Vec3 at = lerp(x[p], x[q], t), whole = cross(b - a, c - a);
        const double ofA = dot(cross(b - at, c - at), whole) / squaredLength(whole);
        const double ofB = dot(cross(c - at, a - at), whole) / squaredLength(whole);
        const std::array<int, 5> particles{p, q, corners[0], corners[1], corners[2]};
        const std::array<double, 5> weights{1 - t, t, -ofA, -ofB, ofA + ofB - 1};
        double mobility = 0;
        for (int i = 0; i < 5; ++i) mobility += weights[i] * weights[i] * substep.inverseMass[particles[i]];
        if (mobility == 0) continue;
        const Vec3 way = shortening * (settings_.pushOutSpeed * substep.duration / size);
        for (int i = 0; i < 5; ++i)
            move(particles[i], way * (weights[i] * substep.inverseMass[particles[i]] / mobility), substep);
    }
}

/// Shortens the ways of particles until every pair has a direction along which it is separated at the start
/// and at the end. A shorter way stays on the right side of every plane that the whole one respected, so this
/// comes to an end.
void SelfContact::holdApart(Substep& substep) {
    constexpr int manyRounds = 50;
    wanted_.assign(substep.positions.begin(), substep.positions.end());
    fraction_.assign(wanted_.size(), 1.0);
    for (int round = 0; round < manyRounds; ++round) {
        bool all = true;
        for (std::size_t i = 0; i < watches_.size(); ++i) {
            Watch& watch = watches_[i];
            watch.now = leastDistance(watch, substep.positions);
            if ((watch.now > 0 && watch.before > 0) || isSeparated(watch, contacts_[i], substep)) continue;
            shorten(watch, contacts_[i], substep);
            all = false;
        }
        if (all) return;
    }
    std::ranges::copy(substep.previous, substep.positions.begin()); // nothing moves in this substep
    for (Watch& watch : watches_) watch.now = watch.before;
}

/// What must be left of a distance [m]: nothing is let nearer than `closest`, however often it is pressed.
double SelfContact::keptOf(double start) const {
    return std::min(start, std::max(settings_.keptDistance * std::min(start, thickest_), settings_.closest));
}

bool SelfContact::isSeparated(const Watch& watch, Contact& contact, const Substep& substep) const {
    const auto along = [&](const Vec3& direction) {
        const double start = gapAlong(direction, watch.elements, substep.previous);
        return start > 0 && gapAlong(direction, watch.elements, substep.positions) >= justEnough * keptOf(start);
    };
    if (along(contact.direction)) return true;
    look(watch, contact, substep.previous);
    return contact.start <= noDistance || along(contact.direction); // what has no distance is crossed, and not held
}

/// Neither element crosses a plane of its own between them.
void SelfContact::shorten(const Watch& watch, const Contact& contact, Substep& substep) {
    const auto& v = watch.elements.vertices;
    const double gap = gapAlong(contact.direction, watch.elements, substep.previous);
    const double kept = keptOf(gap);
    double second = -infinity; // where the second element ends along the direction
    for (int k = watch.elements.firstCount; k < 4; ++k)
        second = std::max(second, dot(contact.direction, substep.previous[v[k]]));
    for (int i = 0; i < 4; ++i) {
        const bool isFirst = i < watch.elements.firstCount;
        const double plane = second + 0.5 * (isFirst ? gap + kept : gap - kept);
        const double from = dot(contact.direction, substep.previous[v[i]]),
                     to = dot(contact.direction, substep.positions[v[i]]);
        if (isFirst ? to < plane : to > plane)
            goPartOfTheWay(v[i], fraction_[v[i]] * std::clamp((from - plane) / (from - to), 0.0, 1.0), substep);
    }
}

void SelfContact::goPartOfTheWay(int particle, double fraction, Substep& substep) {
    const auto go = [&](int p, double part) {
        fraction_[p] = std::min(fraction_[p], part);
        substep.positions[p] = lerp(substep.previous[p], wanted_[p], fraction_[p]);
    };
    if (slaveOf_[particle] < 0) {
        go(particle, fraction);
    } else {
        const auto& masters = model_.slaves[slaveOf_[particle]].masters;
        for (const auto& [master, weight] : masters) fraction = std::min(fraction, fraction_[master]);
        for (const auto& [master, weight] : masters) go(master, fraction);
    }
    placeSlaves(substep.positions);
}

// ---- Statics
// --------------------------------------------------------------------------------------------------------

double SelfContact::stiffnessOf(const Watch& watch) const {
    const auto& v = watch.elements.vertices;
    return settings_.stiffness * 0.25 * (mass_[v[0]] + mass_[v[1]] + mass_[v[2]] + mass_[v[3]]);
}

void SelfContact::beginIteration(std::span<const Vec3> positions) {
    const bool first = anchors_.empty();
    if (first) {
        anchors_.assign(positions.begin(), positions.end());
        mayPierce_ = true; // who calls may have come here by ways that nobody held
    }
    // Pairs beyond the reach need four moves to meet; neighbours are sought again after the first of a
    // particle's two.
    if (first || farthestMove(from_, positions) > settings_.staticMove)
        search(4 * settings_.staticMove + thickest_, positions, {});
    iterationStart_.assign(positions.begin(), positions.end());
    moves_.clear();
    ++substep_;
    for (std::size_t i = 0; i < watches_.size(); ++i) {
        const Watch& watch = watches_[i];
        Contact& contact = contacts_[i];
        double force = 0;
        if (leastDistance(watch, positions) < watch.target + 2 * settings_.staticMove) {
            look(watch, contact, positions);
            if (contact.start > noDistance) force = pressureAt(watch, contact.start);
        }
        contact.normalForce = std::max(contact.normalForce * (first ? 1 : keptNormalForce), force);
        if (contact.normalForce < leastForce) contact.normalForce = 0;
    }
}

/// For layers pressed to half their thickness, where each particle is in as many pairs as on a sheet that
/// lies on another.
double SelfContact::largestFrequencySquared() const {
    constexpr double pairs = 12;
    return pairs * settings_.stiffness * barrierCurvature(0.5);
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

/// Nothing is to be felt of this pair, and it cannot cross.
bool SelfContact::isFar(const Watch& watch, const Contact& contact, std::span<const Vec3> positions) const {
    if (contact.normalForce > 0) return contact.start <= noDistance;
    return leastDistance(watch, positions) > watch.target || contact.start <= noDistance;
}

double SelfContact::energy(std::span<const Vec3> positions) const {
    if (farthestMove(iterationStart_, positions) > settings_.staticMove) return infinity;
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

} // namespace toile::dynamics
