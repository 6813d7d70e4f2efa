// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BodyContact.h"

#include "core/base/Contracts.h"
#include "core/collision/FirstTouch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace toile::dynamics {
namespace {

/// Overlaps deeper than this are led out at the bounded speed and no faster [m].
constexpr double deepOverlap = 0.001;
/// What slips by more in a substep is stopped where it is met: flung cloth would be overrun by a limb before [m].
constexpr double fastSlip = 2.5e-4;
/// Samples in a thread's part at least: where none asks the body, they take some microseconds.
constexpr int leastAlone = 1000;

/// Gershgorin rows of what the samples add to M⁻¹K [1/s²]. Particles that have no sample of their own are
/// carried by others; their mass is not known here.
double boundOf(std::span<const ContactSample> samples, const BodyContactSettings& settings) {
    constexpr double deepestDent = 4e-4; // [m]
    std::map<int, double> mass, row;
    for (const ContactSample& sample : samples)
        if (sample.particles.size() == 1 && sample.mass > 0) mass[sample.particles[0].first] = sample.mass;
    for (const ContactSample& sample : samples) {
        const double friction = 2 * sample.friction * deepestDent / settings.frictionGive;
        double sum = 0;
        for (const auto& [particle, weight] : sample.particles) sum += weight;
        for (const auto& [particle, weight] : sample.particles)
            row[particle] += settings.stiffness * sample.mass * std::max(1.0, friction) * weight * sum;
    }
    double largest = 0;
    for (const auto& [particle, m] : mass) largest = std::max(largest, row[particle] / m);
    return largest;
}

} // namespace

std::vector<ContactSample> particleSamples(const cloth::ClothModel& model, std::span<const double> halfThickness,
                                           std::span<const double> clothFriction, double bodyFriction) {
    std::vector<ContactSample> samples;
    samples.reserve(model.mass.size());
    for (int i = 0; i < model.particleCount(); ++i)
        samples.push_back({{{i, 1.0}}, halfThickness[i], std::sqrt(clothFriction[i] * bodyFriction), model.mass[i]});
    for (const cloth::Slave& slave : model.slaves) {
        ContactSample& sample = samples[slave.particle];
        sample.particles = slave.masters;
        sample.mass = 0;
        for (const auto& [master, weight] : slave.masters) sample.mass += weight * model.mass[master];
    }
    return samples;
}

ContactSample middleOf(std::span<const ContactSample* const> corners) {
    ContactSample middle;
    const double share = 1.0 / static_cast<double>(corners.size());
    for (const ContactSample* corner : corners) {
        for (const auto& [particle, weight] : corner->particles) {
            const auto known = std::ranges::find(middle.particles, particle, &std::pair<int, double>::first);
            if (known != middle.particles.end()) known->second += share * weight;
            else middle.particles.emplace_back(particle, share * weight);
        }
        middle.halfThickness += share * corner->halfThickness;
        middle.friction += share * corner->friction;
        middle.mass += share * corner->mass;
    }
    return middle;
}

BodyContact::BodyContact(const collision::BodySurface& body, std::vector<ContactSample> samples,
                         BodyContactSettings settings, std::span<const int> pinned)
    : settings_(settings), tracker_(body, samples.size(), settings.planeReach) {
    samples_.reserve(samples.size());
    for (const ContactSample& given : samples) {
        expects(!given.particles.empty(), "a contact sample lies on particles");
        samples_.push_back({static_cast<int>(terms_.size()), static_cast<int>(given.particles.size()),
                            settings.skinOffset + given.halfThickness, given.friction, settings.stiffness * given.mass,
                            0});
        for (const auto& [particle, weight] : given.particles) terms_.push_back({particle, weight});
    }
    std::vector<bool> taken(terms_.empty() ? 0 : std::ranges::max(terms_, {}, &Term::particle).particle + 1);
    const auto isPinned = [&](const Term& term) { return std::ranges::binary_search(pinned, term.particle); };
    for (int s = 0; s < std::ssize(samples_); ++s) {
        if (std::ranges::all_of(termsOf(samples_[s]), isPinned)) continue;
        const int particle = termsOf(samples_[s])[0].particle;
        const bool isAlone = samples_[s].termCount == 1 && !taken[particle];
        (isAlone ? alone_ : blends_).push_back(s);
        if (isAlone) taken[particle] = true;
    }
    std::ranges::reverse(blends_);
    frequencySquared_ = boundOf(samples, settings);
}

double BodyContact::largestFrequencySquared() const {
    return frequencySquared_;
}

std::size_t BodyContact::bytes() const {
    return terms_.capacity() * sizeof(Term) + samples_.capacity() * sizeof(Sample) +
           (blends_.capacity() + alone_.capacity()) * sizeof(int) + mayCancel_.capacity() * sizeof(double) +
           (pushed_.capacity() + left_.capacity()) * sizeof(Vec3) + tracker_.bytes() +
           (pushing_ ? sizeof(Pushing) + pushing_->distance.bytes() +
                           pushing_->patches.capacity() * sizeof(collision::SmoothDistance::Patch) +
                           pushing_->anchors.capacity() * sizeof(Vec3) + pushing_->near.capacity() * sizeof(int) +
                           pushing_->normalForceBefore.capacity() * sizeof(double)
                     : 0);
}

void BodyContact::project(Substep& substep) {
    if (pushing_) pushing_->anchors.clear();
    if (motion_) follow(substep.time);
    const ContactPace pace(substep.duration, settings_.pushOutTime, settings_.pushOutSpeed);
    mayCancel_.assign(substep.positions.size(), 0);
    pushed_.resize(substep.positions.size());
    for (const int s : blends_) meet(s, pace, substep);
    inParts(substep.team, static_cast<int>(alone_.size()), leastAlone, [&](int begin, int end) {
        for (int i = begin; i < end; ++i) {
            meet(alone_[i], pace, substep);
            rub(termsOf(samples_[alone_[i]])[0].particle, substep);
        }
    });
    if (settings_.bearsLayers) left_.assign(substep.positions.begin(), substep.positions.end());
}

/// Friction of all that has pressed a particle, once all have pushed it. Friction of samples between particles that
/// came before would move cloth that is at rest: it would cancel ways that the pushes after it cancel as well.
void BodyContact::rub(int particle, Substep& substep) const {
    if (mayCancel_[particle] <= 0 || pushed_[particle] == Vec3{}) return;
    const Vec3 way = substep.positions[particle] - substep.previous[particle];
    const Vec3 slip = tangential(way, normalized(pushed_[particle]));
    const double slipped = length(slip);
    if (slipped > 0) substep.positions[particle] -= slip * std::min(1.0, mayCancel_[particle] / slipped);
}

void BodyContact::follow(double time) {
    motion_->moveTo(time);
    tracker_.bodyMoved(motion_->farthestWay());
}

void BodyContact::meet(std::size_t s, const ContactPace& pace, Substep& substep) {
    Sample& sample = samples_[s];
    const Vec3 now = at(sample, substep.positions);
    if (tracker_.stillFar(s, now, sample.distance)) {
        sample.normalForce = 0;
        return;
    }
    sample.normalForce *= pace.remembered();
    const Vec3 before = at(sample, substep.previous);
    if (motion_) return meetMoving(s, now, before, pace, substep);
    if (squaredLength(now - before) > sample.distance * sample.distance) // could have crossed the skin
        if (const auto touch = collision::firstTouch(tracker_.body(), before, now, sample.distance))
            return resolve(sample, {touch->point, touch->normal}, now, before, pace, substep);
    if (const auto* near = tracker_.near(s, now, sample.distance)) resolve(sample, *near, now, before, pace, substep);
}

/// Beside a body that moves, cloth is seen from the place of the body it is near: what counts is the way relative to
/// it.
void BodyContact::meetMoving(std::size_t s, const Vec3& now, const Vec3& before, const ContactPace& pace,
                             Substep& substep) {
    Sample& sample = samples_[s];
    const collision::SurfacePoint near = tracker_.find(s, now);
    const Vec3 carried = before + motion_->wayOf(near);
    if (squaredLength(now - carried) > sample.distance * sample.distance)
        if (const auto touch = collision::firstTouch(tracker_.body(), carried, now, sample.distance))
            return resolve(sample, {touch->point, touch->normal}, now, before + motion_->wayOf(*touch), pace, substep);
    if (near.signedDistance <= sample.distance) resolve(sample, {near.point, near.normal}, now, carried, pace, substep);
}

/// How far a sample was pressed towards the body after the last substep's contact with it [m].
double BodyContact::pressedIn(const Sample& sample, const Vec3& normal, const Substep& substep) const {
    return left_.empty() ? 0 : std::max(0.0, dot(at(sample, left_) - at(sample, substep.previous), normal));
}

/// What layers have pressed in is no overlap to be led out slowly: what presses would be faster, and creep into the
/// body.
void BodyContact::resolve(Sample& sample, const collision::TangentPlane& plane, const Vec3& now, const Vec3& before,
                          const ContactPace& pace, Substep& substep) {
    const double start = plane.distance(before) + pressedIn(sample, plane.normal, substep);
    const double lift = pace.allowedDistance(start, sample.distance) - plane.distance(now);
    const bool ledOut = sample.distance - start > deepOverlap;
    if (lift <= 0 && !ledOut) return;

    double mobility = 0; // [1/kg]
    for (const Term& term : termsOf(sample)) mobility += term.weight * term.weight * substep.inverseMass[term.particle];
    if (mobility == 0) return; // all pinned: the pin wins

    Vec3 move = plane.normal * lift;
    const Vec3 slip = tangential(now - before, plane.normal);
    const double limit = sample.friction * std::max(lift, 0.0), slipped = length(slip);
    const bool atOnce = motion_ || slipped > fastSlip;
    if (atOnce && slipped > 0) move += slip * -std::min(1.0, limit / slipped);
    for (const Term& term : termsOf(sample)) {
        const double share = term.weight * substep.inverseMass[term.particle] / mobility;
        substep.positions[term.particle] += move * share;
        if (!atOnce && limit > 0) press(term.particle, move * share, limit * share);
    }

    const double force = std::max(lift, 0.0) / (mobility * substep.duration * substep.duration);
    sample.normalForce += pace.learnt() * force;
}

void BodyContact::press(int particle, const Vec3& push, double cancels) {
    pushed_[particle] = mayCancel_[particle] > 0 ? pushed_[particle] + push : push;
    mayCancel_[particle] += cancels;
}

ContactReport BodyContact::report(std::span<const Vec3> positions) const {
    constexpr double touching = 1e-4; // [m]
    const double anywhere = std::numeric_limits<double>::infinity();
    ContactReport report{anywhere, 0, 0};
    for (const Sample& sample : samples_) {
        const double distance = tracker_.body().nearest(at(sample, positions), anywhere)->signedDistance;
        report.smallestClearance = std::min(report.smallestClearance, distance);
        report.contacts += distance <= sample.distance + touching;
    }
    report.largestPenetration = std::max(0.0, -report.smallestClearance);
    return report;
}

} // namespace toile::dynamics
