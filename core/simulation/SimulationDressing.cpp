// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/SeamClosing.h"
#include "core/simulation/Simulation.h"

#include <algorithm>
#include <limits>

/// How a garment is put on: which seams and tacks are drawn together when, and when they are closed.
namespace toile::simulation {
namespace {

constexpr MergeRule mergeRule;
constexpr TackSettings tackSettings;
/// A seam that is still open this long after its ramp ended is given up, so that the next order may begin [s].
constexpr double patience = 2.0;

/// Particles that become one take their common centre of mass and momentum; where one is pinned, its place.
dynamics::ParticleState merged(const dynamics::ParticleState& before, const Garment& from, const Garment& to) {
    constexpr double massOfSlaves = 1e-12; // a slave has no mass of its own and never merges; any weight will do
    const int count = to.particles.particleCount;
    dynamics::ParticleState after{std::vector<Vec3>(count), std::vector<Vec3>(count), before.time};
    std::vector<double> mass(count, 0);
    std::vector<int> becomes(from.particles.particleCount, -1);
    for (std::size_t node = 0; node < from.particles.particleOf.size(); ++node) {
        const int old = from.particles.particleOf[node], now = to.particles.particleOf[node];
        if (becomes[old] >= 0) continue;
        becomes[old] = now;
        const double m = std::max(from.model.mass[old], massOfSlaves);
        after.positions[now] += before.positions[old] * m;
        after.velocities[now] += before.velocities[old] * m;
        mass[now] += m;
    }
    for (int particle = 0; particle < count; ++particle) {
        after.positions[particle] = after.positions[particle] / mass[particle];
        after.velocities[particle] = after.velocities[particle] / mass[particle];
    }
    for (const int pinned : from.model.pinned) {
        after.positions[becomes[pinned]] = before.positions[pinned];
        after.velocities[becomes[pinned]] = {};
    }
    return after;
}

} // namespace

std::vector<std::size_t> Simulation::closingSeams() const {
    std::vector<std::size_t> closing;
    for (std::size_t seam = 0; seam < seams_.size(); ++seam)
        if (!seams_[seam].merged && seamStart_[seam] >= 0) closing.push_back(seam);
    return closing;
}

bool Simulation::isOver(double start, double startGap, double since) const {
    const double closing = SeamClosing::durationOf(startGap, {.duration = scene_.settings.seamTime});
    return start >= 0 && state_.time > start + closing + since;
}

double Simulation::startGapOf(std::size_t seam) const {
    const std::vector<double>& gaps = seamGaps_[seam];
    return gaps.empty() ? 0 : std::ranges::max(gaps);
}

bool Simulation::givenUp(std::size_t seam) const {
    return isOver(seamStart_[seam], startGapOf(seam), patience);
}

bool Simulation::givenUp(const TackState& tack) const {
    return isOver(tack.start, tack.startGap, patience);
}

std::size_t Simulation::closingTacks() const {
    return std::ranges::count_if(tacks_, [&](const TackState& tack) { return tack.start >= 0 && !tack.closed; });
}

Phase Simulation::duePhase() const {
    for (std::size_t seam = 0; seam < seams_.size(); ++seam)
        if (!seams_[seam].merged && !givenUp(seam)) return Phase::sewing;
    for (const TackState& tack : tacks_)
        if (!tack.closed && !givenUp(tack)) return Phase::sewing;
    if (phase_ == Phase::sewing) return drapingMethod_ ? Phase::shaking : Phase::draping;
    const double leastTime = isCalm_ ? std::min(dressing.leastShaking, shakingTime()) : shakingTime();
    return state_.time > sewnTime_ + leastTime ? Phase::draping : phase_;
}

void Simulation::startDue() {
    // The smallest order that is not done yet begins; one that cannot close does not hold up the next for ever.
    int due = std::numeric_limits<int>::max();
    for (std::size_t seam = 0; seam < seams_.size(); ++seam)
        if (!seams_[seam].merged && !givenUp(seam)) due = std::min(due, seams_[seam].order);
    for (const TackState& tack : tacks_)
        if (!tack.closed && !givenUp(tack)) due = std::min(due, tack.order);
    for (std::size_t tack = 0; tack < tacks_.size(); ++tack) {
        if (tacks_[tack].start >= 0 || tacks_[tack].order > due) continue;
        startTack(tack);
    }
    for (std::size_t seam = 0; seam < seams_.size(); ++seam) {
        if (seams_[seam].merged || seamStart_[seam] >= 0 || seams_[seam].order > due) continue;
        startSeam(seam);
    }
}

void Simulation::startTack(std::size_t tack) {
    tacks_[tack].start = state_.time;
    tacks_[tack].startGap = gapOfTack(tack);
}

void Simulation::startSeam(std::size_t seam) {
    seamStart_[seam] = state_.time;
    seamGaps_[seam].clear();
    for (const auto& [a, b] : garment_->mesh->seams[seam].pairs)
        seamGaps_[seam].push_back(geometry::distance(state_.positions[garment_->particles.particle(a)],
                                                     state_.positions[garment_->particles.particle(b)]));
}

bool Simulation::mayMerge(std::size_t seam) const {
    const bool isLate = isOver(seamStart_[seam], startGapOf(seam), mergeRule.late);
    const double gap = isLate ? mergeRule.lateGap : mergeRule.gap;
    return std::ranges::all_of(garment_->mesh->seams[seam].pairs, [&](const auto& pair) {
        const int a = garment_->particles.particle(pair[0]), b = garment_->particles.particle(pair[1]);
        return geometry::distance(state_.positions[a], state_.positions[b]) <= gap &&
               geometry::distance(state_.velocities[a], state_.velocities[b]) <= mergeRule.relativeSpeed;
    });
}

Result<bool> Simulation::mergeReadySeams() {
    std::vector<bool> mergedSeams = garment_->mergedSeams;
    bool changed = false;
    for (const std::size_t seam : closingSeams()) {
        if (!mayMerge(seam)) continue;
        seams_[seam].gapAtMerge = gapOf(seam).maximum;
        mergedSeams[seam] = changed = true;
    }
    if (!changed) return false;
    auto sewn = makeGarment(scene_.pattern, garment_->mesh, std::move(mergedSeams), scene_.paper);
    if (!sewn) return tl::unexpected(sewn.error());
    state_ = merged(state_, *garment_, *sewn);
    garment_ = std::make_unique<const Garment>(std::move(*sewn));
    sleepers_.reset();
    levels_.reset();
    whyNoLevels_.clear();
    takesOneMore_ = true;
    pinToBody();
    for (std::size_t seam = 0; seam < seams_.size(); ++seam) seams_[seam].merged = garment_->mergedSeams[seam];
    return true;
}

bool Simulation::hasClosed(const TackState& tack) const {
    const ParticleMap& particles = garment_->particles;
    return gapBetween(tack, particles, state_.positions) <= tackSettings.closedGap &&
           length(wayBetween(tack, particles, state_.velocities)) <= tackSettings.closedSpeed;
}

/// From then on their threads hold with their whole strength, also where forces are solved for.
bool Simulation::closeReadyTacks() {
    bool changed = false;
    for (TackState& tack : tacks_)
        if (tack.start >= 0 && !tack.closed && hasClosed(tack)) tack.closed = changed = true;
    return changed;
}

void Simulation::goOnDressing(bool closedSome) {
    const std::size_t closing = closingSeams().size() + closingTacks();
    startDue();
    const Phase due = duePhase();
    if (due != phase_ && phase_ == Phase::sewing) {
        sewnTime_ = state_.time;
        noteSewn();
    }
    const bool planStands = !closedSome && due == phase_ && closingSeams().size() + closingTacks() == closing &&
                            !(plannedLevels_ > 0 && !levelsMayHelp());
    if (planStands && damping() == plannedDamping_) return;
    if (planStands && phase_ == Phase::draping && !integrator_) return dampAnew();
    phase_ = due;
    rebuildPlan();
}

bool Simulation::allSeamsMerged() const {
    return std::ranges::all_of(seams_, [](const SeamState& seam) { return seam.merged; });
}

SeamGap Simulation::gapOf(std::size_t seam) const {
    SeamGap gap;
    const auto& pairs = garment_->mesh->seams[seam].pairs;
    for (const auto& [a, b] : pairs) {
        const double d = geometry::distance(state_.positions[garment_->particles.particle(a)],
                                            state_.positions[garment_->particles.particle(b)]);
        gap.maximum = std::max(gap.maximum, d);
        gap.mean += d / static_cast<double>(pairs.size());
    }
    return gap;
}

double Simulation::gapOfTack(std::size_t tack) const {
    return gapBetween(tacks_[tack], garment_->particles, state_.positions);
}

} // namespace toile::simulation
