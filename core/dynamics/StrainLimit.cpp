// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/StrainLimit.h"

#include "core/cloth/TriangleStrain.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace toile::dynamics {

StrainLimit::StrainLimit(const cloth::ClothModel& model, std::span<const int> pulled, StrainLimitSettings settings)
    : sweeps_(settings.sweeps) {
    for (const cloth::Spring& s : model.structural)
        lengths_.push_back({{s.a, s.b, -1}, {-1, 1, 0}, s.restLength * (1 + settings.strain)});
    for (const cloth::MembraneTriangle& t : model.triangles) {
        const cloth::CornerWeights w = cloth::cornerWeights(t);
        const auto longest = [&](double stiffness) {
            return 1 + (stiffness > 0 ? std::max(settings.strain, settings.tension / stiffness)
                                      : std::numeric_limits<double>::infinity());
        };
        lengths_.push_back({t.particles, {w.u[0], w.u[1], w.u[2]}, longest(t.stiffness.c11)});
        lengths_.push_back({t.particles, {w.v[0], w.v[1], w.v[2]}, longest(t.stiffness.c22)});
    }
    sortOutward(pulled, model.mass.size());
}

/// By the number of lengths between them and the nearest particle that is pulled: one sweep then carries a pull all the
/// way.
void StrainLimit::sortOutward(std::span<const int> pulled, std::size_t particleCount) {
    constexpr int unreached = std::numeric_limits<int>::max();
    std::vector<std::vector<int>> lengthsAt(particleCount);
    for (std::size_t i = 0; i < lengths_.size(); ++i)
        for (const int p : lengths_[i].particles)
            if (p >= 0) lengthsAt[p].push_back(static_cast<int>(i));
    std::vector<int> rank(lengths_.size(), unreached), queue(pulled.begin(), pulled.end());
    std::vector<char> isQueued(particleCount, 0);
    for (const int p : queue) isQueued[p] = 1;
    int next = 0;
    for (std::size_t i = 0; i < queue.size(); ++i)
        for (const int length : lengthsAt[queue[i]]) {
            if (rank[length] == unreached) rank[length] = next++;
            for (const int p : lengths_[length].particles) {
                if (p < 0 || isQueued[p]) continue;
                isQueued[p] = 1;
                queue.push_back(p);
            }
        }
    std::vector<std::size_t> order(lengths_.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return rank[i]; });
    std::vector<Length> sorted;
    sorted.reserve(order.size());
    for (const std::size_t i : order) sorted.push_back(lengths_[i]);
    lengths_ = std::move(sorted);
}

/// False if it is not too long, or pinned.
bool StrainLimit::shorten(const Length& length, Substep& substep) {
    Vec3 way;
    double mobility = 0; // [1/kg]
    for (int i = 0; i < 3; ++i) {
        const int p = length.particles[i];
        if (p < 0) continue;
        way += length.coefficients[i] * substep.positions[p];
        mobility += length.coefficients[i] * length.coefficients[i] * substep.inverseMass[p];
    }
    const double squared = squaredLength(way);
    if (squared <= length.longest * length.longest || mobility == 0) return false;
    const double size = std::sqrt(squared);
    const Vec3 push = way * ((length.longest - size) / (size * mobility));
    for (int i = 0; i < 3; ++i)
        if (const int p = length.particles[i]; p >= 0)
            substep.positions[p] += push * (length.coefficients[i] * substep.inverseMass[p]);
    return true;
}

/// After the first sweep only as far outward as the one before found anything too long.
void StrainLimit::project(Substep& substep) {
    std::size_t end = lengths_.size();
    for (int sweep = 0; sweep < sweeps_; ++sweep) {
        std::size_t reach = 0;
        for (std::size_t i = 0; i < end; ++i)
            if (shorten(lengths_[i], substep)) reach = i + 1;
        end = reach;
    }
}

} // namespace toile::dynamics
