// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

/// Which pairs of elements are near, and for how long that list holds.
namespace toile::dynamics {
namespace {

using collision::ElementPair;
using collision::Separation;

/// Part of the distance at rest that compressed cloth may fall to before its own parts push each other [–].
constexpr double usedRoom = 0.5;

} // namespace

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

double SelfContact::targetOf(const ElementPair& pair) const {
    const auto& v = pair.vertices;
    const auto half = [&](int i) { return surface_.halfThickness[v[i]]; };
    double room = std::numeric_limits<double>::infinity();
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

/// Finds the direction and the weights of the shortest way at some positions.
void SelfContact::look(const Watch& watch, Contact& contact, std::span<const Vec3> positions) const {
    const Separation found = collision::separationOf(watch.elements, positions);
    contact.substep = substep_;
    contact.start = found.distance;
    contact.direction = found.distance > noDistance ? found.way / found.distance : Vec3{};
    contact.weights = found.weights;
}

double SelfContact::farthestMove(std::span<const Vec3> from, std::span<const Vec3> to) {
    double squared = 0;
    for (std::size_t p = 0; p < to.size(); ++p) squared = std::max(squared, squaredLength(to[p] - from[p]));
    return std::sqrt(squared);
}

} // namespace toile::dynamics
