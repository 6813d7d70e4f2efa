// SPDX-License-Identifier: GPL-3.0-or-later
/// Contact with the body as an energy, for methods that solve or sum forces: statics, implicit and explicit steps.
#include "core/dynamics/BodyContact.h"
#include "core/dynamics/Friction.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace toile::dynamics {
namespace {

/// What presses a sample out of a dent.
struct Push {
    double energy = 0, force = 0, stiffness = 0;

    /// The same stiffness farther in.
    [[nodiscard]] Push after(double way) const {
        return {energy + force * way + stiffness * way * way / 2, force + stiffness * way, stiffness};
    }
};

/// The energy ½k·dent² of a spring with a soft beginning: its stiffness grows from 0 to k over the onset. Contact that
/// begins or ends in an iteration makes no force jump.
Push softPushOf(double dent, double k, double onset) {
    if (dent <= 0) return {};
    if (dent < onset) return {k * dent * dent * dent / (6 * onset), k * dent * dent / (2 * onset), k * dent / onset};
    return Push{k * onset * onset / 6, k * onset / 2, k}.after(dent - onset);
}

/// A third of the room to the skin may be pressed in so. Farther in the stiffness grows by a factor of e with every
/// sixth of it, so that tight, stiff cloth does not come to the skin; beyond the skin it grows no more, for cloth that
/// begins in the body.
Push pushOf(double dent, double k, double onset, double room) {
    constexpr double exponentAtSkin = 4;
    const double soft = std::max(onset, room / 3), sixth = room / 6;
    if (dent <= soft) return softPushOf(dent, k, onset);
    const double exponent = std::min((dent - soft) / sixth, exponentAtSkin), way = exponent * sixth;
    const double growth = std::exp(exponent);
    const Push before = softPushOf(soft, k, onset);
    const Push hard{before.energy + before.force * way + k * sixth * sixth * (growth - 1 - exponent),
                    before.force + k * sixth * (growth - 1), k * growth};
    return hard.after(dent - soft - way);
}

/// Adds what the turning of the push does where the body is hollow. On its round parts it would take stiffness away and
/// is left out: the Hessian stays positive.
void addTurning(double (&block)[9], double force, const double (&curvature)[9]) {
    using Matrix = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Matrix turning = -force * Eigen::Map<const Matrix>(curvature);
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(turning);
    for (int k = 0; k < 3; ++k) {
        const auto axis = solver.eigenvectors().col(k);
        if (solver.eigenvalues()[k] > 0) addOuter(block, {axis[0], axis[1], axis[2]}, solver.eigenvalues()[k]);
    }
}

} // namespace

/// What has slipped further than friction gives drags its anchor behind it; what has not keeps it, and so
/// sticks without creeping from step to step.
void BodyContact::beginStep(const ParticleState& state, double) {
    if (motion_) follow(state.time);
    left_.clear();
    if (!pushing_) return;
    for (std::size_t s = 0; s < pushing_->anchors.size(); ++s) {
        Vec3& anchor = pushing_->anchors[s];
        const Vec3 now = at(samples_[s], state.positions), slip = now - anchor;
        const double slipped = length(slip);
        if (slipped > settings_.frictionGive) anchor = now - slip * (settings_.frictionGive / slipped);
    }
}

BodyContact::Pushing& BodyContact::pushing() {
    if (!pushing_)
        pushing_.reset(new Pushing{collision::SmoothDistance(tracker_.body(), settings_.lattice),
                                   std::vector<collision::SmoothDistance::Patch>(samples_.size()),
                                   {},
                                   {},
                                   {}});
    return *pushing_;
}

void BodyContact::fixFriction(std::span<const Vec3> positions) {
    const bool first = pushing().anchors.empty();
    // The mean force of the substeps is better than that of one place; statics that goes on knows its own, and so does
    // what was recalled.
    const bool knows = std::exchange(recalled_, false);
    const bool begins = std::exchange(beginsStatics_, false) || first || knows;
    const bool takesBack = !begins && takings_ > 0;
    if (takesBack) --takings_;
    pushing_->normalForceBefore.clear();
    for (const Sample& sample : samples_) pushing_->normalForceBefore.push_back(sample.normalForce);
    for (int s = 0; s < static_cast<int>(samples_.size()); ++s) {
        Sample& sample = samples_[s];
        const Vec3 now = at(sample, positions);
        if (first) pushing_->anchors.push_back(now);
        const bool remembered = begins && sample.normalForce > 0;
        if (tracker_.near(s, now, sample.distance + settings_.lattice) == nullptr && !remembered) {
            sample.normalForce = sample.takenBack = 0;
            continue;
        }
        const auto surface = pushing_->distance.at(now, pushing_->patches[s]);
        sample.normal = normalized(surface.gradient);
        const double dent = dentOf(sample, surface.value);
        if (!begins)
            sample.normalForce =
                pushOf(dent, sample.stiffness, settings_.onset, roomOf(sample)).force * length(surface.gradient);
        if (takesBack) sample.takenBack = std::clamp(dent, 0.0, settings_.onset);
    }
}

void BodyContact::easeFriction(double part) {
    for (std::size_t s = 0; s < samples_.size(); ++s)
        samples_[s].normalForce = std::lerp(pushing_->normalForceBefore[s], samples_[s].normalForce, part);
}

/// A few times and no farther than the push has its full stiffness: between two limbs there may be no place for the
/// cloth, and it would be kept farther for ever. What goes on from where statics ended begins with what it knew.
void BodyContact::take(const Motion& motion) {
    beginsStatics_ = motion.span == 0;
    takings_ = beginsStatics_ ? settings_.takings : 0;
    rests_ = motion.span == 0;
    if (pushing_ && !pushing_->anchors.empty()) return;
    for (Sample& sample : samples_) sample.takenBack = 0;
}

void BodyContact::beginIteration(std::span<const Vec3> positions) {
    pushing_->near.clear();
    for (int s = 0; s < static_cast<int>(samples_.size()); ++s) {
        const Sample& sample = samples_[s];
        const double reach = sample.distance + settings_.staticReach;
        if (tracker_.near(s, at(sample, positions), reach) != nullptr || sample.normalForce > 0)
            pushing_->near.push_back(s);
    }
}

/// How much too near the body a place at this distance is.
double BodyContact::dentOf(const Sample& sample, double distance) const {
    return sample.distance + sample.takenBack - distance;
}

/// To the skin, where stiffness may grow: explicit steps would be too long for it, and are as stiff as implicit ones.
double BodyContact::roomOf(const Sample& sample) const {
    return rests_ ? sample.distance : std::numeric_limits<double>::infinity();
}

/// The smooth distance of a sample to the body, if it is too small. Remembers on the way which nodes it rests on.
std::optional<collision::SmoothValue> BodyContact::dentingAt(int s, const Vec3& now) const {
    if (tracker_.stillFar(s, now, samples_[s].distance + settings_.lattice)) return std::nullopt;
    const auto surface = pushing_->distance.at(now, pushing_->patches[s]);
    return dentOf(samples_[s], surface.value) > 0 ? std::optional(surface) : std::nullopt;
}

Vec3 BodyContact::slipOf(int s, const Vec3& now) const {
    return tangential(now - pushing_->anchors[s], samples_[s].normal);
}

double BodyContact::energy(std::span<const Vec3> positions) const {
    double sum = 0;
    for (const int s : pushing_->near) {
        const Sample& sample = samples_[s];
        const Vec3 now = at(sample, positions);
        if (const auto surface = dentingAt(s, now))
            sum += pushOf(dentOf(sample, surface->value), sample.stiffness, settings_.onset, roomOf(sample)).energy;
        if (sample.normalForce > 0)
            sum += sample.friction * sample.normalForce * smoothLength(length(slipOf(s, now)), settings_.frictionGive);
    }
    return sum;
}

void BodyContact::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    for (const int s : pushing_->near) {
        const Sample& sample = samples_[s];
        const Vec3 now = at(sample, positions);
        Vec3 force;
        if (const auto surface = dentingAt(s, now))
            force += surface->gradient *
                     pushOf(dentOf(sample, surface->value), sample.stiffness, settings_.onset, roomOf(sample)).force;
        if (sample.normalForce > 0) {
            const Vec3 slip = slipOf(s, now);
            force -= slip * (sample.friction * sample.normalForce *
                             smoothSlopeOverLength(length(slip), settings_.frictionGive));
        }
        for (const Term& term : termsOf(sample)) forces[term.particle] += force * term.weight;
    }
}

void BodyContact::addHessian(std::span<const Vec3> positions, HessianSink& sink) const {
    for (const int s : pushing_->near) {
        const Sample& sample = samples_[s];
        const Vec3 now = at(sample, positions);
        const auto surface = dentingAt(s, now);
        if (!surface && sample.normalForce == 0) continue;
        double whole[9] = {};
        if (surface) {
            const Push push = pushOf(dentOf(sample, surface->value), sample.stiffness, settings_.onset, roomOf(sample));
            addOuter(whole, surface->gradient, push.stiffness);
            addTurning(whole, push.force, surface->hessian);
        }
        if (sample.normalForce > 0)
            addFrictionCurvature(whole, slipOf(s, now), sample.normal, sample.friction * sample.normalForce,
                                 settings_.frictionGive);
        for (const Term& i : termsOf(sample))
            for (const Term& j : termsOf(sample)) {
                double block[9];
                for (int k = 0; k < 9; ++k) block[k] = i.weight * j.weight * whole[k];
                sink.add(i.particle, j.particle, block);
            }
    }
}

} // namespace toile::dynamics
