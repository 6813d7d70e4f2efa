// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/Grips.h"

#include <algorithm>
#include <limits>

namespace toile::simulation {
namespace {

constexpr double yieldsAt = 0.01; ///< from this distance on a grip pulls with all its strength [m]

/// Bell over the distance from the middle of the held cloth: 1 there, 0 at its rim.
double weightAt(double distance, double radius) {
    const double s = std::clamp(distance / radius, 0.0, 1.0);
    return (1 - s * s) * (1 - s * s);
}

/// Particles of a piece near a place of its material, with their weights, each once; where the radius holds no node the
/// nearest.
std::vector<std::pair<int, double>> held(const Grip& grip, const Garment& garment, std::size_t piece) {
    const std::vector<Vec2>& material = garment.mesh->pieces[piece].material;
    std::vector<std::pair<int, double>> found;
    const auto particleOf = [&](std::size_t node) {
        return garment.particles.particle({static_cast<int>(piece), static_cast<int>(node)});
    };
    std::size_t nearest = 0;
    for (std::size_t node = 0; node < material.size(); ++node) {
        if (distance(material[node], grip.material) < distance(material[nearest], grip.material)) nearest = node;
        const double weight = weightAt(distance(material[node], grip.material), grip.radius);
        if (weight > 0) found.emplace_back(particleOf(node), weight);
    }
    if (found.empty()) return {{particleOf(nearest), 1}};
    std::ranges::sort(found);
    const auto [first, last] = std::ranges::unique(found, {}, &std::pair<int, double>::first);
    found.erase(first, last);
    return found;
}

} // namespace

Grips::Grips(std::shared_ptr<const std::vector<Grip>> grips, const pattern::Pattern& pattern, const Garment& garment,
             std::span<const Vec3> positions)
    : grips_(std::move(grips)) {
    std::vector<double> stiffness(positions.size(), 0);
    for (std::size_t g = 0; g < grips_->size(); ++g) {
        const Grip& grip = (*grips_)[g];
        const auto piece = std::ranges::find_if(
            pattern.pieces, [&](const auto& candidate) { return candidate->id.value == grip.piece; });
        if (piece == pattern.pieces.end()) continue;
        const auto particles = held(grip, garment, static_cast<std::size_t>(piece - pattern.pieces.begin()));
        double weights = 0;
        Vec3 middle;
        for (const auto& [particle, weight] : particles) {
            weights += weight;
            middle += weight * positions[particle];
        }
        middle = middle / weights;
        Hand hand{g, middle, middle, {}};
        for (const auto& [particle, weight] : particles) {
            hand.fingers.push_back({particle, positions[particle] - middle, weight / weights});
            stiffness[particle] += grip.strength * weight / (weights * yieldsAt);
        }
        hands_.push_back(std::move(hand));
    }
    for (std::size_t p = 0; p < stiffness.size(); ++p)
        if (garment.model.mass[p] > 0)
            frequencySquared_ = std::max(frequencySquared_, stiffness[p] / garment.model.mass[p]);
}

std::size_t Grips::bytes() const {
    std::size_t sum = hands_.capacity() * sizeof(Hand);
    for (const Hand& hand : hands_) sum += hand.fingers.capacity() * sizeof(Finger);
    return sum;
}

std::vector<int> Grips::particles() const {
    std::vector<int> held;
    for (const Hand& hand : hands_)
        for (const Finger& finger : hand.fingers) held.push_back(finger.particle);
    return held;
}

void Grips::beginStep(const dynamics::ParticleState& state, double duration) {
    endTime_ = state.time + duration;
    duration_ = duration;
    for (Hand& hand : hands_) {
        const Grip& grip = (*grips_)[hand.grip];
        hand.from = hand.to;
        const Vec3 way = grip.target - hand.from;
        const double far = length(way), step = grip.speed * duration;
        hand.to = far <= step ? grip.target : hand.from + way * (step / far);
    }
}

void Grips::project(dynamics::Substep& substep) {
    const double left = duration_ > 0 ? std::clamp((endTime_ - substep.time) / duration_, 0.0, 1.0) : 0;
    for (const Hand& hand : hands_) {
        const Vec3 place = hand.to + (hand.from - hand.to) * left;
        for (const Finger& finger : hand.fingers) {
            const double w = substep.inverseMass[finger.particle];
            if (w <= 0) continue;
            const double force = (*grips_)[hand.grip].strength * finger.share;
            const Vec3 way = place + finger.offset - substep.positions[finger.particle];
            const double far = length(way), squaredStep = substep.duration * substep.duration;
            // No nearer than its own mass allows (docs/physics/xpbd.md, the cap), and not farther than the force moves
            // it.
            const double compliance = std::max(yieldsAt / (force * squaredStep), w);
            const double step = std::min(far * w / (w + compliance), w * force * squaredStep);
            if (far > 0) substep.positions[finger.particle] += way * (step / far);
        }
    }
}

template <class Visit>
void Grips::eachFinger(Visit visit) const {
    for (const Hand& hand : hands_)
        for (const Finger& finger : hand.fingers)
            visit(finger.particle, hand.to + finger.offset, (*grips_)[hand.grip].strength * finger.share);
}

double Grips::energy(std::span<const Vec3> positions) const {
    double sum = 0;
    eachFinger([&](int particle, const Vec3& place, double force) {
        const double far = geometry::distance(positions[particle], place);
        sum += far <= yieldsAt ? 0.5 * force / yieldsAt * far * far : force * (far - 0.5 * yieldsAt);
    });
    return sum;
}

void Grips::addForces(std::span<const Vec3> positions, std::span<Vec3> forces) const {
    eachFinger([&](int particle, const Vec3& place, double force) {
        const Vec3 way = place - positions[particle];
        forces[particle] += way * (force / std::max(length(way), yieldsAt));
    });
}

void Grips::addHessian(std::span<const Vec3> positions, dynamics::HessianSink& sink) const {
    eachFinger([&](int particle, const Vec3& place, double force) {
        const Vec3 way = place - positions[particle];
        const double far = length(way), across = force / std::max(far, yieldsAt);
        const Vec3 n = far > yieldsAt ? way / far : Vec3{}; // along a constant force there is no stiffness
        double block[9];
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) block[3 * i + j] = across * ((i == j ? 1 : 0) - n[i] * n[j]);
        sink.add(particle, particle, block);
    });
}

} // namespace toile::simulation
