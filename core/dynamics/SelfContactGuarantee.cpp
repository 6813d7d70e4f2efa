// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include <algorithm>
#include <limits>

/// What is apart stays apart: ways are shortened before elements meet.
namespace toile::dynamics {

using collision::gapAlong;

/// Shortens the ways of particles until every pair has a direction along which it is separated at the start
/// and at the end. A shorter way stays on the right side of every plane that the whole one respected, so this
/// comes to an end. Returns how far particles are from the ways foreseen [m].
double SelfContact::holdApart(Substep& substep) {
    constexpr int manyRounds = 50;
    fraction_.clear();
    for (int round = 0; round < manyRounds; ++round) {
        const double from = strayed(substep);
        wake(from, substep);
        findUnseparated(substep);
        if (touching_.empty()) return from;
        if (fraction_.empty()) beginShortening(substep);
        for (const std::size_t i : touching_) // those before it may have gone out of its way
            if (!isSeparated(watches_[i], contacts_[i], substep)) shorten(watches_[i], contacts_[i], substep);
    }
    std::ranges::copy(substep.previous, substep.positions.begin()); // nothing moves in this substep
    for (const std::size_t i : awake_) watches_[i].now = watches_[i].before;
    return strayed(substep);
}

/// The neighbours that beginIteration() found are all that can meet while no particle goes farther from where it was
/// then than twice staticMove. Else, or where the last were those of substeps, all ways of this part are looked at.
void SelfContact::hold(std::span<const Vec3> from, std::span<Vec3> positions) {
    Substep way{.positions = positions, .previous = from, .inverseMass = {}, .duration = frame_};
    way.time = fromTime_ + frame_;
    horizon_ = frame_;
    const auto isKnown = [&](std::span<const Vec3> at) { return farthestMove(from_, at) <= 2 * staticMove_; };
    if (!anchors_.empty() && from_.size() == positions.size() && isKnown(from) && isKnown(positions)) {
        moves_.assign(positions.size(), Vec3{}); // nothing was foreseen
        wake(farthestMove(from_, from), way);    // what is apart at the end of the way may be near at its start
        for (const std::size_t i : awake_) watches_[i].before = leastDistance(watches_[i], from);
        static_cast<void>(holdApart(way));
        return;
    }
    moves_.resize(positions.size());
    if (seekOnAllWays(way)) static_cast<void>(holdApart(way));
    else standStill(way);
    from_.clear(); // the list is of this way only
}

/// Pairs that are not known to be apart and have no direction along which they are.
void SelfContact::findUnseparated(const Substep& substep) {
    flags_.resize(awake_.size());
    inParts(substep.team, static_cast<int>(awake_.size()), leastPairs, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Watch& watch = watches_[awake_[i]];
            watch.now = leastDistance(watch, substep.positions);
            flags_[i] = !(watch.now > 0 && watch.before > 0) && !isSeparated(watch, contacts_[awake_[i]], substep);
        }
    });
    keepFlagged(awake_, touching_);
}

void SelfContact::beginShortening(const Substep& substep) {
    wanted_.assign(substep.positions.begin(), substep.positions.end());
    fraction_.assign(wanted_.size(), 1.0);
}

bool SelfContact::isSeparated(const Watch& watch, Contact& contact, const Substep& substep) const {
    const auto along = [&](const Vec3& direction) {
        const double start = gapAlong(direction, watch.elements, substep.previous);
        return start > 0 &&
               gapAlong(direction, watch.elements, substep.positions) >= justEnough * keptOf(start, settings_.closest);
    };
    if (along(contact.direction)) return true;
    look(watch, contact, substep.previous);
    return contact.start <= noDistance || along(contact.direction); // what has no distance is crossed, and not held
}

/// What must be left of a distance [m]: nothing is let nearer than `closest`, however often it is pressed.
double SelfContact::keptOf(double start, double closest) const {
    return std::min(start, std::max(settings_.keptDistance * std::min(start, thickest_), closest));
}

/// Neither element crosses a plane of its own between them.
void SelfContact::shorten(const Watch& watch, const Contact& contact, Substep& substep) {
    const auto& v = watch.elements.vertices;
    const double gap = gapAlong(contact.direction, watch.elements, substep.previous);
    const double kept = keptOf(gap, settings_.closest);
    double second = -std::numeric_limits<double>::infinity(); // where the second element ends along the direction
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

} // namespace toile::dynamics
