// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/ClothModel.h"

#include <span>
#include <utility>
#include <vector>

namespace toile::dynamics {

/// Which particles are free, and of which free ones the others are made. A pinned slave is pinned.
class Eliminated {
public:
    explicit Eliminated(const cloth::ClothModel& model);

    [[nodiscard]] int count() const { return static_cast<int>(free_.size()); }
    [[nodiscard]] std::span<const int> free() const { return free_; } ///< particle of each unknown, rising
    /// Unknown of a free particle; −1 otherwise.
    [[nodiscard]] int unknownOf(int particle) const { return unknown_[particle]; }

    using Term = std::pair<int, double>;
    /// x(particle) = Σ weight · x(unknown) + a constant: (unknown, weight).
    [[nodiscard]] std::span<const Term> termsOf(int particle) const {
        return {terms_.data() + begin_[particle], terms_.data() + begin_[particle + 1]};
    }
    /// Slaves that follow their masters.
    [[nodiscard]] std::span<const int> slaves() const { return slaves_; } ///< indices into model.slaves

    /// Puts the following slaves where their masters say.
    void place(std::span<Vec3> positions) const;
    /// Σ over masters of what lies on every particle, by unknown.
    [[nodiscard]] std::vector<Vec3> gathered(std::span<const Vec3> perParticle) const;
    /// 1/kg: 0 for pinned particles, Σ w²/m for slaves. A free particle without mass gives 0 and is in massless().
    /// inertia: how many times its mass each particle is taken to have; empty = once.
    [[nodiscard]] std::vector<double> inverseMass(std::span<const double> inertia = {}) const;
    /// A free particle without mass; −1 = none.
    [[nodiscard]] int massless() const { return massless_; }

private:
    const cloth::ClothModel* model_;
    std::vector<int> free_, unknown_, slaves_, begin_;
    std::vector<Term> terms_;
    int massless_ = -1;
};

} // namespace toile::dynamics
