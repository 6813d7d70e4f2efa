// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include <algorithm>
#include <limits>

/// What is apart stays apart: ways are shortened before elements meet.
namespace toile::dynamics {

using collision::gapAlong;

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

bool SelfContact::isSeparated(const Watch& watch, Contact& contact, const Substep& substep) const {
    const auto along = [&](const Vec3& direction) {
        const double start = gapAlong(direction, watch.elements, substep.previous);
        return start > 0 && gapAlong(direction, watch.elements, substep.positions) >= justEnough * keptOf(start);
    };
    if (along(contact.direction)) return true;
    look(watch, contact, substep.previous);
    return contact.start <= noDistance || along(contact.direction); // what has no distance is crossed, and not held
}

/// What must be left of a distance [m]: nothing is let nearer than `closest`, however often it is pressed.
double SelfContact::keptOf(double start) const {
    return std::min(start, std::max(settings_.keptDistance * std::min(start, thickest_), settings_.closest));
}

/// Neither element crosses a plane of its own between them.
void SelfContact::shorten(const Watch& watch, const Contact& contact, Substep& substep) {
    const auto& v = watch.elements.vertices;
    const double gap = gapAlong(contact.direction, watch.elements, substep.previous);
    const double kept = keptOf(gap);
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
