// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include "core/dynamics/Ways.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

/// Which pairs of elements are near, and for how long that list holds.
namespace toile::dynamics {
namespace {

using collision::ElementPair;
using collision::Separation;

/// Part of the distance at rest that compressed cloth may fall to before its own parts push each other [–].
constexpr double usedRoom = 0.5;

/// What the first list is for, half of it [substeps]: seams that have just merged let go of cloth in all directions,
/// and so does cloth that shorter substeps make stiffer.
constexpr int tentative = 2;

/// One of all ways to name a pair.
ElementPair inOrder(ElementPair pair) {
    auto& v = pair.vertices;
    const auto order = [&v](int i, int k) {
        if (v[i] > v[k]) std::swap(v[i], v[k]);
    };
    order(2, 3);
    if (pair.firstCount == 1) {
        order(1, 2);
        order(2, 3);
        return pair;
    }
    order(0, 1);
    if (v[0] > v[2]) v = {v[2], v[3], v[0], v[1]};
    return pair;
}

} // namespace

/// Part of the ways foreseen that is behind the particles.
double SelfContact::doneAt(double time) const {
    return std::clamp((time - fromTime_) / horizon_, 0.0, 1.0);
}

/// How far the farthest particle is from the way that was foreseen when neighbours were sought [m]; infinite where
/// they were not.
double SelfContact::strayed(const Substep& substep) const {
    const std::span<const Vec3> positions = substep.positions;
    if (from_.size() != positions.size()) return std::numeric_limits<double>::infinity();
    const double done = doneAt(substep.time);
    const int count = static_cast<int>(positions.size());
    return std::sqrt(largestInParts(substep.team, count, leastParticles, [&](int begin, int end) {
        double squared = 0;
        for (int p = begin; p < end; ++p)
            squared = std::max(squared, squaredLength(positions[p] - from_[p] - done * moves_[p]));
        return squared;
    }));
}

/// Seeks neighbours for one frame step ahead, as if particles went on as in this substep. For less where the last list
/// did not hold so long, or there was none for such substeps: of cloth in tumult only the next few substeps can be
/// foreseen, and a longer look finds more pairs that never meet. For less, too, where that brings too many near.
bool SelfContact::foresee(const Substep& substep) {
    prepareSearch(substep.previous);
    const double start = substep.time - substep.duration, frame = std::max(frame_, substep.duration);
    const bool isFirst = std::exchange(foreseenWith_, substep.duration) != substep.duration;
    const double lasted = isFirst ? tentative * substep.duration : from_.empty() ? frame : start - fromTime_;
    const double longest = std::clamp(2 * lasted, substep.duration, frame);
    fromTime_ = start;
    moves_.resize(substep.positions.size());
    for (ahead_ = std::min(1.0, 2 * ahead_); ahead_ >= leastAhead; ahead_ *= 0.5) {
        horizon_ = std::min(ahead_ * frame, longest);
        slack_ = ahead_ * mostSlack_;
        for (std::size_t p = 0; p < moves_.size(); ++p)
            moves_[p] = (horizon_ / substep.duration) * (substep.positions[p] - substep.previous[p]);
        if (watch(proximity_->pairsInStep(2 * slack_ + thickest_, substep.previous, moves_, settings_.mostPairs,
                                          substep.team),
                  substep.previous))
            return true;
    }
    return false;
}

/// What was pushed or held has left the ways foreseen: seeks neighbours for whatever part of its way each particle
/// goes. Where they are too many, the list is for this substep only; then all ways are cut to a length.
bool SelfContact::seekOnAllWays(Substep& substep) {
    prepareSearch(substep.previous);
    fromTime_ = substep.time - substep.duration;
    moves_.assign(moves_.size(), Vec3{});
    const auto fits = [&] {
        const auto ways = waysOf(model_, substep.previous, substep.positions);
        return watch(
            proximity_->pairsInBoxes(2 * slack_ + thickest_, substep.previous, ways, settings_.mostPairs, substep.team),
            substep.previous);
    };
    if (fits()) return true;
    slack_ = 0;
    if (fits()) return true;
    const double farthest = farthestMove(substep.previous, substep.positions);
    for (double part = 0.5; part >= leastAhead; part *= 0.5) {
        cutWays(part * farthest, substep);
        if (!fits()) continue;
        ++heldBack_;
        return true;
    }
    return false;
}

void SelfContact::cutWays(double most, Substep& substep) const {
    for (std::size_t p = 0; p < substep.positions.size(); ++p) {
        const Vec3 way = substep.positions[p] - substep.previous[p];
        if (const double size = length(way); size > most)
            substep.positions[p] = substep.previous[p] + way * (most / size);
    }
    placeSlaves(substep.positions);
}

/// Nothing is known of what could meet: nothing moves in this substep, and neighbours are sought anew in the next.
void SelfContact::standStill(Substep& substep) {
    std::ranges::copy(substep.previous, substep.positions.begin());
    from_.clear();
    ++heldBack_;
}

void SelfContact::prepareSearch(std::span<const Vec3> positions) {
    if (!proximity_) {
        proximity_.emplace(surface_.triangles, positions);
        if (!surface_.layers.empty()) findTrianglesOfEdges();
    }
    if (mayPierce_) seekPiercings(positions);
}

/// What an edge that pierces a triangle must pass to come out of it: the triangle's sides, or its corners the triangle.
std::set<ElementPair> SelfContact::crossedPairs() const {
    std::set<ElementPair> pairs;
    for (const auto& [edge, triangle] : piercings_) {
        const auto& [p, q] = proximity_->edges()[edge].vertices;
        const auto& [a, b, c] = proximity_->triangles()[triangle];
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
            pairs.insert(inOrder({{p, q, from, to}, 2}));
        for (const int end : {p, q}) pairs.insert(inOrder({{end, a, b, c}, 1}));
    }
    return pairs;
}

/// Watches these pairs from now on, unless they were too many.
bool SelfContact::watch(const collision::SelfProximity::Pairs& pairs, std::span<const Vec3> positions) {
    if (!pairs) {
        ++shortSearches_;
        return false;
    }
    crossed_ = crossedPairs();
    Pressed pressed;
    for (std::size_t i = 0; i < watches_.size(); ++i)
        if (contacts_[i].normalForce > 0) pressed.emplace(watches_[i].elements, contacts_[i].normalForce);

    watches_.clear();
    contacts_.clear();
    isComingKnown_ = false;
    watches_.reserve(pairs->size());
    contacts_.reserve(pairs->size());
    for (const auto& near : *pairs) add(near, pressed);
    margins_.clear();
    awake_.clear();
    awakeDone_ = awakeStrayed_ = -1;
    hasStrayed_.assign(positions.size(), 0);
    from_.assign(positions.begin(), positions.end());
    ++searches_;
    return true;
}

/// Watches a pair, unless it is one that a seam brings together, of pieces that pass, or of a crossing.
void SelfContact::add(const collision::SelfProximity::Near& near, const Pressed& pressed) {
    const auto& [pair, distance, order] = near;
    if (isIgnored(pair) || (!crossed_.empty() && crossed_.contains(inOrder(pair)))) return;
    watches_.push_back({pair, targetOf(pair), distance, distance, distance, order});
    contacts_.push_back(contactOf(pair));
    if (const auto known = pressed.find(pair); known != pressed.end()) contacts_.back().normalForce = known->second;
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
    return willBeOne(pair) || passes(pair);
}

bool SelfContact::willBeOne(const ElementPair& pair) const {
    if (surface_.becomes.empty()) return false;
    for (int i = 0; i < pair.firstCount; ++i)
        for (int k = pair.firstCount; k < 4; ++k)
            if (surface_.becomes[pair.vertices[i]] == surface_.becomes[pair.vertices[k]]) return true;
    return false;
}

/// What lies along a seam is of the pieces on both its sides, and passes what either passes.
bool SelfContact::passes(const ElementPair& pair) const {
    const std::span<const int> first = std::span(pair.vertices).first(pair.firstCount),
                               second = std::span(pair.vertices).subspan(pair.firstCount);
    const auto areOf = [&](std::span<const int> vertices, int piece) {
        return std::ranges::all_of(vertices, [&](int vertex) { return piecesOf_[vertex].contains(piece); });
    };
    return std::ranges::any_of(surface_.passing, [&](const std::array<int, 2>& pieces) {
        const auto& [a, b] = pieces;
        return (areOf(first, a) && areOf(second, b)) || (areOf(first, b) && areOf(second, a));
    });
}

/// Finds the direction and the weights of the shortest way at some positions.
void SelfContact::look(const Watch& watch, Contact& contact, std::span<const Vec3> positions) const {
    const Separation found = collision::separationOf(watch.elements, positions);
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
