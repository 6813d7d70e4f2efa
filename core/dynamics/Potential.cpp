// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/Potential.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::dynamics {
namespace {

constexpr double standardGravity = 9.81; ///< [m/s²]; scale of residuals where there is no gravity

/// Hands blocks of particles to the unknowns that move them.
class EliminatingSink : public HessianSink {
public:
    EliminatingSink(const Eliminated& eliminated, HessianSink& target) : eliminated_(eliminated), target_(target) {}

    void add(int i, int j, const double (&block)[9]) override {
        for (const auto& [row, rowWeight] : eliminated_.termsOf(i))
            for (const auto& [column, columnWeight] : eliminated_.termsOf(j)) {
                if (row < column) continue; // the matrix keeps the other half
                const double weight = rowWeight * columnWeight;
                if (weight == 1) {
                    target_.add(row, column, block);
                    continue;
                }
                double scaled[9];
                for (int k = 0; k < 9; ++k) scaled[k] = weight * block[k];
                target_.add(row, column, scaled);
            }
    }

private:
    const Eliminated& eliminated_;
    HessianSink& target_;
};

} // namespace

Potential::Potential(const cloth::ClothModel& model, const Eliminated& eliminated, std::span<const double> mass,
                     const MinimiserProblem& problem)
    : model_(model), eliminated_(eliminated), mass_(mass), gravity_(problem.gravity), stages_(problem.stages),
      inertia_(problem.inertia), target_(problem.target), team_(problem.team) {}

double Potential::energyAt(std::span<const Vec3> x) const {
    double energy = cloth::energy(model_, x);
    for (std::size_t u = 0; u < mass_.size(); ++u) {
        const int p = eliminated_.free()[u];
        energy -= mass_[u] * dot(gravity_, x[p]);
        if (inertia_ > 0) energy += 0.5 * inertia_ * mass_[u] * squaredLength(x[p] - target_[p]);
    }
    for (const Stage* stage : stages_) energy += stage->energy(x);
    return energy;
}

Potential::Measured Potential::measuredAt(std::span<const Vec3> x) const {
    std::vector<Vec3> perParticle(x.size());
    cloth::addForces(model_, x, perParticle);
    for (const Stage* stage : stages_) stage->addForces(x, perParticle);
    Measured m{energyAt(x), eliminated_.gathered(perParticle), 0, -1};
    for (std::size_t u = 0; u < mass_.size(); ++u) {
        const int p = eliminated_.free()[u];
        m.forces[u] += mass_[u] * gravity_;
        if (inertia_ > 0) m.forces[u] -= (inertia_ * mass_[u]) * (x[p] - target_[p]);
        const double size = length(m.forces[u]);
        if (size > m.largest || m.worst < 0) {
            m.largest = size;
            m.worst = p;
        }
    }
    return m;
}

double Potential::forceScale() const {
    double total = 0;
    for (double m : mass_) total += m;
    const double g = length(gravity_);
    return total / std::max<std::size_t>(1, mass_.size()) * (g > 0 ? g : standardGravity);
}

double Potential::roundingFloor(std::span<const Vec3> x) const {
    double extent = 0;
    for (const Vec3& p : x) extent = std::max({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    const double heaviest = mass_.empty() ? 0 : std::ranges::max(mass_);
    const double stiffness = cloth::largestStiffness(model_, x) + inertia_ * heaviest;
    return 8 * std::numeric_limits<double>::epsilon() * stiffness * extent / forceScale();
}

void Potential::assemble(std::span<const Vec3> x, cloth::HessianForm form, BlockMatrix& into) const {
    into.clear();
    EliminatingSink sink(eliminated_, into);
    cloth::addHessian(model_, x, form, sink);
    for (const Stage* stage : stages_) stage->addHessian(x, sink);
}

void Potential::moveTo(std::span<Vec3> x, std::span<const Vec3> from, std::span<const Vec3> step,
                       double fraction) const {
    for (std::size_t u = 0; u < step.size(); ++u) {
        const int p = eliminated_.free()[u];
        x[p] = from[p] + fraction * step[u];
    }
    eliminated_.place(x);
}

} // namespace toile::dynamics
