// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include <algorithm>
#include <utility>

/// Mostly a handful of particles stray from the ways foreseen for all: they alone are foreseen anew, and only pairs
/// that have one of them are sought again.
///
/// All keep the clock of the last whole search: at its part d each is at from + d·move, or within the slack of it. What
/// is foreseen anew gets a way that passes through where it is now. What the others' pairs are known by stays as it
/// was; a pair that is found now is known by its distance at `from`, where its particles have never been together: what
/// they have moved since against each other is counted from there as well.
namespace toile::dynamics {
namespace {

/// Who is so far from its way is foreseen anew with those that are too far, for it would be next [of the slack].
constexpr double far = 0.5;
/// Who strays again and goes no farther in a substep is drawn by cloth and pushed back by layers in each: it stays near
/// the middle [of the slack].
constexpr double toAndFro = 1.5;
/// With more than this part of all particles it is not worth it: each costs some ten times as much as in a whole
/// search.
constexpr std::size_t worth = 32;
/// Below this part of the ways in a substep the clock counts as stopped.
constexpr double stopped = 1.0 / 1024;

} // namespace

/// False where all neighbours must be sought anew, as too many have strayed. What was foreseen is spoilt then.
bool SelfContact::renew(const Substep& substep) {
    if (from_.size() != substep.positions.size() || !foreseeStrayed(substep)) return false;
    const auto found = proximity_->pairsOfFlagged(strayed_, from_, moves_, settings_.mostPairs, substep.team);
    if (!found || found->size() + watches_.size() > settings_.mostPairs) return false;
    replaceFlagged(*found);
    ++renewals_;
    return true;
}

/// Flags who has strayed far, and foresees that it goes on as in this substep.
bool SelfContact::foreseeStrayed(const Substep& substep) {
    const double before = doneAt(substep.time - substep.duration), after = doneAt(substep.time), part = after - before;
    const double most = far * slack_ * far * slack_;
    strayed_.assign(from_.size(), 0);
    std::size_t count = 0;
    for (std::size_t p = 0; p < from_.size(); ++p) {
        const Vec3 &start = substep.previous[p], &end = substep.positions[p];
        if (squaredLength(end - from_[p] - after * moves_[p]) <= most) continue;
        strayed_[p] = 1;
        if (++count > from_.size() / worth) return false;
        const bool isAgain = std::exchange(hasStrayed_[p], 1) != 0;
        if (isAgain && squaredLength(end - start) <= toAndFro * slack_ * toAndFro * slack_) {
            moves_[p] = {};
            from_[p] = lerp(start, end, 0.5);
            continue;
        }
        if (part < stopped && squaredLength(end - start) > most) return false; // too fast for a clock that stands still
        moves_[p] = part < stopped ? Vec3{} : (end - start) / part;
        from_[p] = start - before * moves_[p];
    }
    return true;
}

/// Watches these pairs instead of those that have a flagged particle, in the order in which all would have been found.
void SelfContact::replaceFlagged(const std::vector<collision::SelfProximity::Near>& found) {
    const bool areMarginsKnown = margins_.size() == watches_.size();
    std::swap(watches_, before_.watches);
    std::swap(contacts_, before_.contacts);
    std::swap(margins_, before_.margins);
    watches_.clear();
    contacts_.clear();
    margins_.clear();

    Pressed pressed;
    const auto isFlagged = [&](const Watch& watch) {
        return std::ranges::any_of(watch.elements.vertices, [&](int p) { return strayed_[p] != 0; });
    };
    for (std::size_t i = 0; i < before_.watches.size(); ++i)
        if (before_.contacts[i].normalForce > 0 && isFlagged(before_.watches[i]))
            pressed.emplace(before_.watches[i].elements, before_.contacts[i].normalForce);

    const auto addFound = [&](const collision::SelfProximity::Near& near) { // at `from`, as the search was
        add(near, pressed);
        if (areMarginsKnown && margins_.size() < watches_.size()) margins_.push_back(marginOf(watches_.back()));
    };
    auto next = found.begin();
    for (std::size_t i = 0; i < before_.watches.size(); ++i) {
        const Watch& watch = before_.watches[i];
        if (isFlagged(watch)) continue;
        for (; next != found.end() && next->order < watch.order; ++next) addFound(*next);
        watches_.push_back(watch);
        contacts_.push_back(before_.contacts[i]);
        if (areMarginsKnown) margins_.push_back(before_.margins[i]);
    }
    for (; next != found.end(); ++next) addFound(*next);
    awake_.clear();
    awakeDone_ = awakeStrayed_ = -1;
    isComingKnown_ = false;
}

} // namespace toile::dynamics
