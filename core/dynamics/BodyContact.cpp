// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/BodyContact.h"

#include "core/base/Contracts.h"
#include "core/collision/FirstTouch.h"
#include "core/dynamics/Friction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace toile::dynamics {
namespace {

/// Overlaps deeper than this are led out at the bounded speed and no faster [m].
constexpr double deepOverlap = 0.001;
/// Within which the normal force of the substeps is averaged [s].
constexpr double forceMemory = 1.0 / 60;
/// Friction of one iteration rests on at least this part of the normal force of the iteration before, so that
/// a short Newton step, which leaves the contact behind for a moment, does not let the garment slide off [–].
constexpr double keptNormalForce = 0.5;

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
                         BodyContactSettings settings)
    : settings_(settings), tracker_(body, samples.size(), settings.planeReach) {
    samples_.reserve(samples.size());
    for (const ContactSample& given : samples) {
        expects(!given.particles.empty(), "a contact sample lies on particles");
        samples_.push_back({static_cast<int>(terms_.size()), static_cast<int>(given.particles.size()),
                            settings.skinOffset + given.halfThickness, given.friction, settings.stiffness * given.mass,
                            0});
        for (const auto& [particle, weight] : given.particles) terms_.push_back({particle, weight});
    }
    frequencySquared_ = boundOf(samples, settings);
}

double BodyContact::largestFrequencySquared() const {
    return frequencySquared_;
}

std::size_t BodyContact::bytes() const {
    return terms_.capacity() * sizeof(Term) + samples_.capacity() * sizeof(Sample) + tracker_.bytes() +
           anchors_.capacity() * sizeof(Vec3) + touches_.capacity() * sizeof(Touch);
}

/// What has slipped further than friction gives drags its anchor behind it; what has not keeps it, and so
/// sticks without creeping from step to step.
void BodyContact::beginStep(const ParticleState& state, double) {
    for (std::size_t s = 0; s < anchors_.size(); ++s) {
        const Vec3 now = at(samples_[s], state.positions), slip = now - anchors_[s];
        const double slipped = length(slip);
        if (slipped > settings_.frictionGive) anchors_[s] = now - slip * (settings_.frictionGive / slipped);
    }
}

void BodyContact::project(Substep& substep) {
    anchors_.clear();
    const double remembered = std::exp(-substep.duration / forceMemory);
    for (std::size_t s = 0; s < samples_.size(); ++s) {
        Sample& sample = samples_[s];
        const Vec3 now = at(sample, substep.positions);
        if (tracker_.stillFar(s, now, sample.distance)) {
            sample.normalForce = 0;
            continue;
        }
        sample.normalForce *= remembered;
        const Vec3 before = at(sample, substep.previous);
        if (squaredLength(now - before) > sample.distance * sample.distance) { // could have crossed the skin
            if (const auto touch = collision::firstTouch(tracker_.body(), before, now, sample.distance)) {
                resolve(sample, {touch->point, touch->normal}, now, before, substep);
                continue;
            }
        }
        if (const auto* near = tracker_.near(s, now, sample.distance)) resolve(sample, *near, now, before, substep);
    }
}

void BodyContact::resolve(Sample& sample, const collision::TangentPlane& plane, const Vec3& now, const Vec3& before,
                          Substep& substep) const {
    const double start = plane.distance(before);
    const double allowed =
        allowedDistance(start, sample.distance, substep.duration, settings_.pushOutTime, settings_.pushOutSpeed);
    const double lift = allowed - plane.distance(now);
    const bool ledOut = sample.distance - start > deepOverlap;
    if (lift <= 0 && !ledOut) return;

    double mobility = 0; // [1/kg]
    for (const Term& term : termsOf(sample)) mobility += term.weight * term.weight * substep.inverseMass[term.particle];
    if (mobility == 0) return; // all pinned: the pin wins

    Vec3 move = plane.normal * lift;
    const Vec3 slip = tangential(now - before, plane.normal);
    const double limit = sample.friction * std::max(lift, 0.0), slipped = length(slip);
    if (slipped > 0) move += slip * -std::min(1.0, limit / slipped);
    for (const Term& term : termsOf(sample))
        substep.positions[term.particle] += move * (term.weight * substep.inverseMass[term.particle] / mobility);

    const double force = std::max(lift, 0.0) / (mobility * substep.duration * substep.duration);
    sample.normalForce -= std::expm1(-substep.duration / forceMemory) * force;
}

void BodyContact::beginIteration(std::span<const Vec3> positions) {
    const bool first = anchors_.empty();
    if (first)
        for (const Sample& sample : samples_) anchors_.push_back(at(sample, positions));
    touches_.clear();
    for (std::size_t s = 0; s < samples_.size(); ++s) {
        Sample& sample = samples_[s];
        const Vec3 now = at(sample, positions);
        const auto* plane = tracker_.near(s, now, sample.distance + settings_.staticReach);
        const double kept = sample.normalForce * (first ? 1 : keptNormalForce);
        const double dent = plane ? sample.distance - plane->distance(now) : 0;
        sample.normalForce = std::max({kept, sample.stiffness * dent, 0.0});
        if (plane) touches_.push_back({static_cast<int>(s), *plane, sample.normalForce, anchors_[s]});
    }
}

double BodyContact::energy(std::span<const Vec3> positions) const {
    double sum = 0;
    for (const Touch& touch : touches_) {
        const Sample& sample = samples_[touch.sample];
        const Vec3 now = at(sample, positions);
        const double dent = std::max(0.0, sample.distance - touch.plane.distance(now));
        const Vec3 slip = tangential(now - touch.anchor, touch.plane.normal);
        sum += 0.5 * sample.stiffness * dent * dent +
               sample.friction * touch.normalForce * smoothLength(length(slip), settings_.frictionGive);
    }
    return sum;
}

void BodyContact::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    for (const Touch& touch : touches_) {
        const Sample& sample = samples_[touch.sample];
        const Vec3 now = at(sample, positions);
        const double dent = std::max(0.0, sample.distance - touch.plane.distance(now));
        const Vec3 slip = tangential(now - touch.anchor, touch.plane.normal);
        const double drag =
            sample.friction * touch.normalForce * smoothSlopeOverLength(length(slip), settings_.frictionGive);
        const Vec3 force = touch.plane.normal * (sample.stiffness * dent) - slip * drag;
        for (const Term& term : termsOf(sample)) forces[term.particle] += force * term.weight;
    }
}

void BodyContact::addHessian(std::span<const Vec3> positions, HessianSink& sink) const {
    for (const Touch& touch : touches_) {
        const Sample& sample = samples_[touch.sample];
        const Vec3 now = at(sample, positions);
        const bool pressed = touch.plane.distance(now) < sample.distance;
        if (!pressed && touch.normalForce == 0) continue;
        double whole[9] = {};
        if (pressed) addOuter(whole, touch.plane.normal, sample.stiffness);
        addFrictionCurvature(whole, tangential(now - touch.anchor, touch.plane.normal), touch.plane.normal,
                             sample.friction * touch.normalForce, settings_.frictionGive);
        for (const Term& i : termsOf(sample))
            for (const Term& j : termsOf(sample)) {
                double block[9];
                for (int k = 0; k < 9; ++k) block[k] = i.weight * j.weight * whole[k];
                sink.add(i.particle, j.particle, block);
            }
    }
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
