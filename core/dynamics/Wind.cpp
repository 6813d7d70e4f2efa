// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Wind.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::dynamics {
namespace {

template <class Vectors>
Vec3 meanOf(const Face& face, const Vectors& vectors) {
    const auto [a, b, c] = face.particles;
    return (vectors[a] + vectors[b] + vectors[c]) / 3;
}

void give(const Face& face, const Vec3& force, std::span<Vec3> forces) {
    for (const int p : face.particles) forces[p] += force / 3;
}

} // namespace

Wind::Wind(const cloth::ClothModel& model, std::vector<Face> faces, const WindSettings& settings)
    : model_(model), faces_(std::move(faces)), settings_(settings), sails_(faces_.size()) {}

std::size_t Wind::bytes() const {
    return faces_.capacity() * sizeof(Face) + sails_.capacity() * sizeof(Sail) + forces_.capacity() * sizeof(Vec3);
}

Wind::Sail Wind::sailOf(const Face& face, std::span<const Vec3> positions) const {
    const Vec3 area = areaOf(face, positions);
    const double size = length(area);
    return {size > 0 ? area / size : Vec3{}, 0.5 * settings_.density * settings_.coefficient * size};
}

/// Each face is slowed down as if it were alone with its own mass m: u′ = u − h·k·|u′|·u′/m, which never overshoots.
/// Together the faces of a particle give it the mean of what each would be left with, by mass, and a mean has the
/// smaller kinetic energy: in still air drag takes energy at any speed and in steps of any length.
void Wind::project(Substep& substep) {
    const double h = substep.duration;
    forces_.assign(substep.positions.size(), {});
    for (const Face& face : faces_) {
        const Sail sail = sailOf(face, substep.positions);
        const Vec3 way = meanOf(face, substep.positions) - meanOf(face, substep.previous);
        const double speed = dot(way / h - settings_.velocity, sail.normal);
        const double left = 2 * speed / (1 + std::sqrt(1 + 4 * h * sail.drag * std::abs(speed) / face.mass));
        give(face, (-sail.drag * std::abs(left) * left) * sail.normal, forces_);
    }
    moveBy(forces_, model_, substep);
}

/// In statics half way from what it was: cloth that turns out of the wind loses what turned it, and would turn back.
void Wind::fixFriction(std::span<const Vec3> positions) {
    const bool rests = motion_.velocities.empty() && motion_.from.empty();
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        Sail now = sailOf(faces_[f], positions);
        if (const Sail& before = sails_[f]; rests && before.drag > 0) {
            const Vec3 mean = before.normal + now.normal;
            if (length(mean) > 0) now = {normalized(mean), 0.5 * (before.drag + now.drag)};
        }
        sails_[f] = now;
    }
}

double Wind::speedOf(std::size_t face, const Vec3& velocity) const {
    return dot(velocity - settings_.velocity, sails_[face].normal);
}

Wind::Pull Wind::pullOf(std::size_t face, std::span<const Vec3> positions) const {
    const Face& sail = faces_[face];
    const double drag = sails_[face].drag;
    const bool isGiven = !motion_.velocities.empty();
    const double given = speedOf(face, isGiven ? meanOf(sail, motion_.velocities) : Vec3{});
    if (motion_.from.empty()) {
        // An explicit step may stop a face against the wind, and not turn it round.
        const double most = isGiven ? sail.mass / motion_.span : std::numeric_limits<double>::infinity();
        const double force = -std::min(drag * std::abs(given), most) * given;
        return {force, -force * dot(sails_[face].normal, meanOf(sail, positions)), 0};
    }
    const double u = speedOf(face, (meanOf(sail, positions) - meanOf(sail, motion_.from)) / motion_.span);
    const double pace = std::abs(isGiven ? given : u), stiffness = 2 * drag * pace / motion_.span;
    if (isGiven) return {-drag * pace * (2 * u - given), motion_.span * drag * pace * (u - given) * u, stiffness};
    return {-drag * pace * u, motion_.span * drag * pace * u * u / 3, stiffness};
}

double Wind::energy(std::span<const Vec3> positions) const {
    double sum = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) sum += pullOf(f, positions).energy;
    return sum;
}

void Wind::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    for (std::size_t f = 0; f < faces_.size(); ++f)
        give(faces_[f], pullOf(f, positions).force * sails_[f].normal, forces);
}

void Wind::addHessian(std::span<const Vec3> positions, HessianSink& sink) const {
    if (motion_.from.empty()) return; // a constant force
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        const Vec3& n = sails_[f].normal;
        const double stiffness = pullOf(f, positions).stiffness / 9;
        double block[9];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) block[3 * i + j] = stiffness * n[i] * n[j];
        for (const int p : faces_[f].particles)
            for (const int q : faces_[f].particles) sink.add(p, q, block);
    }
}

} // namespace toile::dynamics
