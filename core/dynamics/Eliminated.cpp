// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Eliminated.h"

#include "core/base/Contracts.h"

namespace toile::dynamics {

Eliminated::Eliminated(const cloth::ClothModel& model) : model_(&model) {
    const int particles = model.particleCount();
    std::vector<char> isPinned(particles, 0);
    std::vector<int> slaveOf(particles, -1);
    for (int particle : model.pinned) isPinned[particle] = 1;
    for (int s = 0; s < static_cast<int>(model.slaves.size()); ++s) {
        const int particle = model.slaves[s].particle;
        if (isPinned[particle]) continue;
        slaveOf[particle] = s;
        slaves_.push_back(s);
    }
    unknown_.assign(particles, -1);
    for (int p = 0; p < particles; ++p) {
        if (isPinned[p] || slaveOf[p] >= 0) continue;
        unknown_[p] = static_cast<int>(free_.size());
        free_.push_back(p);
        if (massless_ < 0 && !(model.mass[p] > 0)) massless_ = p;
    }
    for (int p = 0; p < particles; ++p) {
        begin_.push_back(static_cast<int>(terms_.size()));
        if (unknown_[p] >= 0) terms_.emplace_back(unknown_[p], 1.0);
        if (slaveOf[p] < 0) continue;
        for (const auto& [master, weight] : model.slaves[slaveOf[p]].masters) {
            expects(slaveOf[master] < 0, "masters are no slaves");
            if (unknown_[master] >= 0) terms_.emplace_back(unknown_[master], weight);
        }
    }
    begin_.push_back(static_cast<int>(terms_.size()));
}

void Eliminated::place(std::span<Vec3> positions) const {
    for (int s : slaves_) {
        const cloth::Slave& slave = model_->slaves[s];
        Vec3 place;
        for (const auto& [master, weight] : slave.masters) place += weight * positions[master];
        positions[slave.particle] = place;
    }
}

std::vector<Vec3> Eliminated::gathered(std::span<const Vec3> perParticle) const {
    std::vector<Vec3> sums(free_.size());
    for (int p = 0; p < static_cast<int>(perParticle.size()); ++p)
        for (const auto& [unknown, weight] : termsOf(p)) sums[unknown] += weight * perParticle[p];
    return sums;
}

std::vector<double> Eliminated::inverseMass(std::span<const double> inertia) const {
    std::vector<double> inverse(unknown_.size(), 0.0);
    for (std::size_t p = 0; p < inverse.size(); ++p)
        for (const auto& [unknown, weight] : termsOf(static_cast<int>(p))) {
            const double mass = model_->mass[free_[unknown]] * (inertia.empty() ? 1 : inertia[free_[unknown]]);
            if (mass > 0) inverse[p] += weight * weight / mass;
        }
    return inverse;
}

} // namespace toile::dynamics
