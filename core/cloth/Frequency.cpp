// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Contracts.h"
#include "core/cloth/FoldAngle.h"
#include "core/cloth/Forces.h"
#include "core/cloth/MembraneCellForces.h"
#include "core/cloth/TriangleStrain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace toile::cloth {
namespace {

/// Largest eigenvalue of [[c11, c12], [c12, c22]], or c33 if that is larger.
double largestModulus(const material::MembraneStiffness& c) {
    const double mean = 0.5 * (c.c11 + c.c22), half = 0.5 * (c.c11 - c.c22);
    return std::max(mean + std::hypot(half, c.c12), c.c33);
}

double steepest(const std::vector<material::TensionPoint>& curve) {
    double slope = 1;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const double strain = i > 0 ? curve[i - 1].strain : 0, factor = i > 0 ? curve[i - 1].modulusFactor : 1;
        const double run = curve[i].strain - strain;
        if (run > 0)
            slope = std::max(slope, curve[i].modulusFactor + curve[i].strain * (curve[i].modulusFactor - factor) / run);
    }
    return slope;
}

double steepest(const ClothModel& model, int tension) {
    if (tension < 0) return 1;
    return std::max(steepest(model.tensionCurves[tension].warp), steepest(model.tensionCurves[tension].weft));
}

/// Gershgorin: for every particle the sum of the norms of its row of blocks of K [N/m].
class RowSums {
public:
    explicit RowSums(std::size_t particles) : sums_(particles, 0.0) {}

    /// K = k·c cᵀ between the particles.
    template <class Particles, class Coefficients>
    void addRankOne(const Particles& particles, const Coefficients& coefficients, double k) {
        double total = 0;
        for (double c : coefficients) total += std::abs(c);
        for (std::size_t i = 0; i < std::size(particles); ++i)
            if (particles[i] >= 0) sums_[particles[i]] += k * std::abs(coefficients[i]) * total;
    }
    [[nodiscard]] std::vector<double>& values() { return sums_; }

private:
    std::vector<double> sums_;
};

std::vector<double> rowSums(const ClothModel& model, std::span<const Vec3> positions) {
    RowSums rows(model.mass.size());
    for (const auto* springs : {&model.structural, &model.shear, &model.elastics, &model.flexion})
        for (const Spring& s : *springs) rows.addRankOne(std::array{s.a, s.b}, std::array{-1.0, 1.0}, s.stiffness);
    for (const auto* stencils : {&model.bending, &model.twist})
        for (const Stencil& s : *stencils) rows.addRankOne(s.particles, s.coefficients, s.stiffness);
    for (const Hinge& h : model.hinges) {
        const FoldAngle fold = foldAngle(positions[h.a], positions[h.b], positions[h.c], positions[h.d]);
        std::array<double, 4> norms;
        for (int i = 0; i < 4; ++i) norms[i] = length(fold.gradient[i]);
        rows.addRankOne(std::array{h.a, h.b, h.c, h.d}, norms, h.stiffness);
    }
    for (const MembraneTriangle& t : model.triangles) {
        const CornerWeights w = cornerWeights(t);
        std::array<double, 3> norms;
        for (int i = 0; i < 3; ++i) norms[i] = std::hypot(w.u[i], w.v[i]);
        rows.addRankOne(t.particles, norms, t.area * largestModulus(t.stiffness) * steepest(model, t.tension));
    }
    for (const MembraneCell& c : model.cells) {
        // Sides one by one, as springs; the coupling is not larger than what C11 and C22 add.
        const double k = 0.5 * c.width * c.height * largestModulus(c.stiffness) * steepest(model, c.tension);
        for (const auto& weights : sideWeights(c)) rows.addRankOne(c.particles, weights, k);
        const double u = 0.5 / c.width, v = 0.5 / c.height;
        rows.addRankOne(c.particles, std::array<double, 4>{u + v, u + v, u + v, u + v},
                        c.width * c.height * c.stiffness.c33);
    }
    return rows.values();
}

} // namespace

std::vector<double> frequenciesSquared(const ClothModel& model, std::span<const Vec3> positions) {
    expects(model.hinges.empty() || positions.size() == model.mass.size(), "hinges are bounded where they are");
    std::vector<double> rows = rowSums(model, positions);
    std::vector<char> held(model.mass.size(), 0);
    for (int particle : model.pinned) held[particle] = 1;
    for (const Slave& slave : model.slaves) {
        for (const auto& [master, weight] : slave.masters) rows[master] += std::abs(weight) * rows[slave.particle];
        held[slave.particle] = 1;
    }
    for (std::size_t p = 0; p < rows.size(); ++p) {
        if (held[p]) rows[p] = 0;
        if (rows[p] == 0) continue;
        rows[p] = model.mass[p] > 0 ? rows[p] / model.mass[p] : std::numeric_limits<double>::infinity();
    }
    return rows;
}

double largestFrequencySquared(const ClothModel& model, std::span<const Vec3> positions) {
    const auto each = frequenciesSquared(model, positions);
    return each.empty() ? 0 : std::ranges::max(each);
}

double largestStiffness(const ClothModel& model, std::span<const Vec3> positions) {
    const auto rows = rowSums(model, positions);
    return rows.empty() ? 0 : std::ranges::max(rows);
}

} // namespace toile::cloth
