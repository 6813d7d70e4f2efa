// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include "core/base/Contracts.h"
#include "core/dynamics/Friction.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace toile::dynamics {
namespace {

using collision::gapAlong;

} // namespace

SelfContact::SelfContact(const cloth::ClothModel& model, ClothSurface surface, SelfContactSettings settings)
    : model_(model), surface_(std::move(surface)), settings_(settings), mass_(model.mass),
      slaveOf_(model.mass.size(), -1) {
    const std::size_t count = model.mass.size();
    expects(surface_.halfThickness.size() == count && surface_.friction.size() == count &&
                surface_.room.size() == count,
            "one value per particle");
    expects(surface_.becomes.empty() || surface_.becomes.size() == count, "one per particle, or none");
    expects(surface_.passing.empty() || surface_.pieces.size() == surface_.triangles.size(),
            "of what passes it is known of which piece it is");
    for (std::size_t s = 0; s < model.slaves.size(); ++s) {
        const cloth::Slave& slave = model.slaves[s];
        slaveOf_[slave.particle] = static_cast<int>(s);
        mass_[slave.particle] = 0;
        for (const auto& [master, weight] : slave.masters) mass_[slave.particle] += weight * model.mass[master];
    }
    if (!surface_.passing.empty()) piecesOf_.resize(count);
    for (std::size_t t = 0; t < surface_.triangles.size() && !piecesOf_.empty(); ++t)
        for (const int corner : surface_.triangles[t]) piecesOf_[corner].insert(surface_.pieces[t]);
    for (const double half : surface_.halfThickness) thickest_ = std::max(thickest_, 2 * half);
    std::vector<double> rooms = surface_.room;
    const auto middle = rooms.begin() + std::ssize(rooms) / 2;
    std::nth_element(rooms.begin(), middle, rooms.end());
    const double room = rooms.empty() ? std::numeric_limits<double>::infinity() : *middle;
    mostSlack_ = std::min(settings_.slack, settings_.slackOfRoom * room);
    mostStaticMove_ = std::min(settings_.staticMove, settings_.staticMoveOfRoom * room);
}

std::size_t SelfContact::bytes() const {
    const std::size_t vectors =
        from_.capacity() + moves_.capacity() + wanted_.capacity() + anchors_.capacity() + iterationStart_.capacity();
    const auto pairs = [](const auto& now, const auto& before) {
        return (now.capacity() + before.capacity()) * sizeof(now[0]);
    };
    return vectors * sizeof(Vec3) + flags_.capacity() + strayed_.capacity() + hasStrayed_.capacity() +
           pairs(watches_, before_.watches) + pairs(contacts_, before_.contacts) + pairs(margins_, before_.margins) +
           rubbing_.capacity() * sizeof(Rubbing) + normalForceBefore_.capacity() * sizeof(double) +
           coming_.capacity() * sizeof(Coming) + awake_.capacity() * sizeof(std::size_t) +
           (proximity_ ? proximity_->bytes() : 0);
}

void SelfContact::beginStep(const ParticleState& state, double duration) {
    frame_ = duration;
    const bool isRepeated = seenUntil_ > state.time + duration / 2; // from where it began
    // Layers cross, statics has been at work, or what was seen last was taken back: look again.
    if (mayPierce_ || !anchors_.empty() || isRepeated) from_.clear();
    anchors_.clear();
}

void SelfContact::project(Substep& substep) {
    anchors_.clear();
    seenUntil_ = substep.time;
    double from = strayed(substep);
    if (!(from <= slack_)) {
        if (!renew(substep) && !foresee(substep)) return standStill(substep);
        from = strayed(substep);
    }
    wake(from, substep);
    if (areAllApart(substep) && piercings_.empty() && from <= slack_) return;
    pushApart(substep);
    uncross(substep);
    placeSlaves(substep.positions);
    if (holdApart(substep) <= slack_) return;
    if (renew(substep) && holdApart(substep) <= slack_) return;
    if (seekOnAllWays(substep)) static_cast<void>(holdApart(substep));
    else standStill(substep);
}

/// Whether no pair touches, and all are known to be separated. Finds those that touch; the distances of those that are
/// awake are of this substep from now on.
bool SelfContact::areAllApart(const Substep& substep) {
    std::atomic<bool> areApart{true};
    flags_.resize(awake_.size());
    inParts(substep.team, static_cast<int>(awake_.size()), leastPairs, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            flags_[i] = touches(awake_[i], substep);
            const Watch& watch = watches_[awake_[i]];
            if (flags_[i] || !(watch.now > 0 && watch.before > 0)) areApart.store(false, std::memory_order_relaxed);
        }
    });
    keepFlagged(awake_, touching_);
    return areApart;
}

/// Layers that would come nearer than their thickness are lifted to it.
void SelfContact::pushApart(Substep& substep) {
    const ContactPace pace(substep.duration, settings_.pushOutTime, settings_.pushOutSpeed);
    for (int sweep = 0; sweep < settings_.sweeps; ++sweep) {
        for (const std::size_t i : touching_) push(watches_[i], contacts_[i], pace, substep);
        if (!model_.slaves.empty()) placeSlaves(substep.positions);
    }
}

/// Whether the layers of a pair would come nearer than their thickness.
bool SelfContact::touches(std::size_t pair, const Substep& substep) {
    Watch& watch = watches_[pair];
    Contact& contact = contacts_[pair];
    watch.before = watch.now;
    watch.now = leastDistance(watch, substep.positions);
    if (watch.now > watch.target && watch.before > 0) return false;
    if (gapAlong(contact.direction, watch.elements, substep.positions) > watch.target) return false;
    return meetsOnTheWay(watch, contact, substep);
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

void SelfContact::push(const Watch& watch, Contact& contact, const ContactPace& pace, Substep& substep) const {
    const auto& v = watch.elements.vertices;
    for (const int p : v) // what has pushed its masters in this sweep has pushed it as well
        if (slaveOf_[p] >= 0) placeSlave(slaveOf_[p], substep.positions);
    Vec3 way, slip;
    double mobility = 0; // [1/kg]
    for (int i = 0; i < 4; ++i) {
        way += contact.weights[i] * substep.positions[v[i]];
        slip += contact.weights[i] * (substep.positions[v[i]] - substep.previous[v[i]]);
        mobility += contact.weights[i] * contact.weights[i] * substep.inverseMass[v[i]];
    }
    const double lift = pace.allowedDistance(contact.start, watch.target) - dot(way, contact.direction);
    if (lift <= 0 || mobility == 0) return;
    Vec3 correction = contact.direction * lift;
    slip = tangential(slip, contact.direction);
    const double slipped = length(slip);
    if (slipped > 0) correction -= slip * std::min(1.0, contact.friction * lift / slipped);
    for (int i = 0; i < 4; ++i)
        move(v[i], correction * (contact.weights[i] * substep.inverseMass[v[i]] / mobility), substep);
    const double force = lift / (mobility * substep.duration * substep.duration);
    contact.normalForce += pace.learnt() * (force - contact.normalForce);
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

} // namespace toile::dynamics
