// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SelfContact.h"

#include <algorithm>
#include <cmath>

/// Which of the pairs that are watched have to be looked at in a substep.
///
/// Where every particle has gone the part d of its way foreseen and is within s of it, the ends of a pair have moved by
/// at most d·way + 2s against each other. Most pairs are known by this to be farther apart than they have to be; they
/// sleep, and cost nothing until particles have strayed so far that it no longer tells.
namespace toile::dynamics {
namespace {

/// Pairs are woken for this part of the ways and of the slack more than is needed now, so that it is seldom done.
constexpr double stepAhead = 0.125;
constexpr double rounding = 1e-12; // [m]

} // namespace

SelfContact::Margin SelfContact::marginOf(const Watch& watch) const {
    const auto& v = watch.elements.vertices;
    double squared = 0;
    for (int i = 0; i < watch.elements.firstCount; ++i)
        for (int k = watch.elements.firstCount; k < 4; ++k)
            squared = std::max(squared, squaredLength(moves_[v[i]] - moves_[v[k]]));
    return {watch.known - watch.target - rounding, std::sqrt(squared)};
}

void SelfContact::findMargins(Team* team) {
    margins_.resize(watches_.size());
    inParts(team, static_cast<int>(watches_.size()), leastPairs, [&](int begin, int end) {
        for (int w = begin; w < end; ++w) margins_[w] = marginOf(watches_[w]);
    });
}

/// Wakes all pairs that may be at their target or nearer, now that particles are so far from their ways [m].
void SelfContact::wake(double strayed, const Substep& substep) {
    if (margins_.size() != watches_.size()) findMargins(substep.team);
    const double done = doneAt(substep.time);
    if (done <= awakeDone_ && strayed <= awakeStrayed_) return;
    awakeDone_ = std::min(1.0, std::max(awakeDone_, done + stepAhead));
    awakeStrayed_ = std::max(awakeStrayed_, strayed + stepAhead * slack_);
    inParts(substep.team, static_cast<int>(margins_.size()), leastPairs, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            Margin& margin = margins_[i];
            if (margin.isAwake || margin.distance > awakeDone_ * margin.way + 2 * awakeStrayed_) continue;
            margin.isAwake = true;
            Watch& watch = watches_[i];
            watch.before = watch.now = leastDistance(watch, substep.previous);
        }
    });
    awake_.clear();
    for (std::size_t i = 0; i < margins_.size(); ++i)
        if (margins_[i].isAwake) awake_.push_back(i);
}

/// Those of the pairs whose flags are up, in the same order.
void SelfContact::keepFlagged(std::span<const std::size_t> from, std::vector<std::size_t>& kept) const {
    kept.clear();
    for (std::size_t i = 0; i < from.size(); ++i)
        if (flags_[i]) kept.push_back(from[i]);
}

} // namespace toile::dynamics
