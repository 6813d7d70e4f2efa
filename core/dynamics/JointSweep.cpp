// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/JointSweep.h"

#include "core/cloth/FoldAngle.h"
#include "core/cloth/MembraneCellForces.h"
#include "core/cloth/Tension.h"
#include "core/cloth/TriangleStrain.h"

#include <algorithm>
#include <cmath>

namespace toile::dynamics {
namespace {

/// Solves A·y = b in place by Cholesky; A symmetric positive definite.
template <int N>
void solveSmall(std::array<std::array<double, N>, N>& a, std::array<double, N>& b) {
    for (int i = 0; i < N; ++i) {
        for (int j = 0; j < i; ++j) {
            double sum = a[i][j];
            for (int k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
            a[i][j] = sum / a[j][j];
        }
        double diagonal = a[i][i];
        for (int k = 0; k < i; ++k) diagonal -= a[i][k] * a[i][k];
        a[i][i] = std::sqrt(diagonal);
    }
    for (int i = 0; i < N; ++i) {
        for (int k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
        b[i] /= a[i][i];
    }
    for (int i = N - 1; i >= 0; --i) {
        for (int k = i + 1; k < N; ++k) b[i] -= a[k][i] * b[k];
        b[i] /= a[i][i];
    }
}

constexpr double shortest = 1e-12; ///< [m]; a shorter spring has no direction of its own

} // namespace

JointSweep::JointSweep(const cloth::ClothModel& model, const Eliminated& eliminated,
                       std::span<const double> inverseMass, double h, double cap)
    : model_(model), eliminated_(eliminated), inverseMass_(inverseMass), h_(h), cap_(cap),
      slaveOf_(model.mass.size(), -1) {
    for (int s : eliminated.slaves()) slaveOf_[model.slaves[s].particle] = s;
    const auto joined = [&](const auto& elements, auto particlesOf) {
        std::vector<int> indices;
        for (int e = 0; e < std::ssize(elements); ++e)
            if (touches(particlesOf(elements[e]))) indices.push_back(e);
        return indices;
    };
    triangles_ = joined(model.triangles, [](const auto& t) { return t.particles; });
    cells_ = joined(model.cells, [](const auto& c) { return c.particles; });
    hinges_ = joined(model.hinges, [](const auto& hinge) { return cornersOf(hinge); });
}

double JointSweep::compliance(double stiffness, double inverseMass) const {
    return std::max(1 / (stiffness * h_ * h_), inverseMass / cap_);
}

bool JointSweep::touches(std::span<const int> particles) const {
    return std::ranges::any_of(particles, [&](int p) { return p >= 0 && slaveOf_[p] >= 0; });
}

void JointSweep::add(std::span<const int> particles, std::span<const double> coefficients, double restLength,
                     double stiffness) {
    // Pinned particles stay in the sum: they are points of it although nothing moves them.
    std::vector<Term> terms;
    const auto add = [&](int particle, double coefficient) {
        const auto it = std::ranges::find(terms, particle, &Term::particle);
        if (it != terms.end()) it->coefficient += coefficient;
        else terms.push_back({particle, coefficient, 0});
    };
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (slaveOf_[particles[i]] < 0) {
            add(particles[i], coefficients[i]);
            continue;
        }
        for (const auto& [master, weight] : model_.slaves[slaveOf_[particles[i]]].masters)
            add(master, weight * coefficients[i]);
    }
    double w = 0;
    for (const Term& t : terms) w += inverseMass_[t.particle] * t.coefficient * t.coefficient;
    if (w == 0) return;
    const double share = 1 / (w + compliance(stiffness, w));
    for (Term& t : terms) t.correction = inverseMass_[t.particle] * t.coefficient * share;
    const int begin = static_cast<int>(terms_.size());
    terms_.insert(terms_.end(), terms.begin(), terms.end());
    expanded_.push_back({begin, static_cast<int>(terms_.size()), restLength});
}

void JointSweep::apply(std::span<Place> places) const {
    applyTriangles(places);
    applyCells(places);
    applyExpanded(places);
    applyHinges(places);
}

void JointSweep::applyExpanded(std::span<Place> x) const {
    for (const Expanded& e : expanded_) {
        Vec3 value;
        for (int t = e.begin; t < e.end; ++t) value += terms_[t].coefficient * x[terms_[t].particle];
        if (e.restLength > 0) value *= 1 - e.restLength / std::max(geometry::length(value), shortest);
        for (int t = e.begin; t < e.end; ++t) x[terms_[t].particle] -= terms_[t].correction * value;
    }
}

Vec3 JointSweep::placeOf(int particle, std::span<const Place> x) const {
    if (slaveOf_[particle] < 0) return x[particle];
    Vec3 place;
    for (const auto& [master, weight] : model_.slaves[slaveOf_[particle]].masters) place += weight * x[master];
    return place;
}

/// A particle that an element moves, with the gradients of the element's constraints there.
template <int Constraints>
struct JointSweep::Mover {
    int particle;
    double inverseMass;
    std::array<Vec3, Constraints> gradients;
};

template <int Constraints, int Corners>
void JointSweep::solveBlock(std::span<Place> x, const std::array<int, Corners>& particles,
                            const std::array<double, Constraints>& values,
                            const std::array<std::array<Vec3, Corners>, Constraints>& gradients,
                            const std::array<double, Constraints>& stiffness) const {
    std::vector<Mover<Constraints>> movers; // corners become their masters
    for (int corner = 0; corner < Corners; ++corner)
        for (const auto& [unknown, weight] : eliminated_.termsOf(particles[corner])) {
            const int particle = eliminated_.free()[unknown];
            auto it = std::ranges::find(movers, particle, &Mover<Constraints>::particle);
            if (it == movers.end()) it = movers.insert(it, {particle, inverseMass_[particle], {}});
            for (int c = 0; c < Constraints; ++c) it->gradients[c] += weight * gradients[c][corner];
        }
    solveMovers<Constraints>(x, movers, values, stiffness);
}

/// Solves a few constraints of one element together: (G W Gᵀ + compliance)·λ = −C, Δx = W Gᵀ λ.
template <int Constraints>
void JointSweep::solveMovers(std::span<Place> x, std::span<const Mover<Constraints>> movers,
                             const std::array<double, Constraints>& values,
                             const std::array<double, Constraints>& stiffness) const {
    std::array<std::array<double, Constraints>, Constraints> a{};
    for (const auto& mover : movers)
        for (int c = 0; c < Constraints; ++c) {
            const Vec3 weighted = mover.inverseMass * mover.gradients[c];
            for (int d = 0; d <= c; ++d) a[c][d] += dot(weighted, mover.gradients[d]);
        }
    std::array<double, Constraints> lambda;
    for (int c = 0; c < Constraints; ++c) {
        lambda[c] = -values[c];
        if (!(stiffness[c] > 0) || !(a[c][c] > 0)) { // nothing to do for this one
            for (int d = 0; d < c; ++d) a[c][d] = 0;
            for (int d = c + 1; d < Constraints; ++d) a[d][c] = 0;
            a[c][c] = 1;
            lambda[c] = 0;
            continue;
        }
        a[c][c] += compliance(stiffness[c], a[c][c]);
    }
    solveSmall<Constraints>(a, lambda);
    for (const auto& mover : movers) {
        Vec3 move;
        for (int c = 0; c < Constraints; ++c) move += lambda[c] * mover.gradients[c];
        x[mover.particle] += mover.inverseMass * move;
    }
}

void JointSweep::applyHinges(std::span<Place> x) const {
    for (int index : hinges_) {
        const cloth::Hinge& h = model_.hinges[index];
        const std::array<int, 4> particles = cornersOf(h);
        const cloth::FoldAngle fold =
            cloth::foldAngle(placeOf(h.a, x), placeOf(h.b, x), placeOf(h.c, x), placeOf(h.d, x));
        solveBlock<1, 4>(x, particles, {cloth::angleFrom(h.restAngle, fold.angle)}, {fold.gradient}, {h.stiffness});
    }
}

void JointSweep::applyTriangles(std::span<Place> x) const {
    static const cloth::TensionCurves linear;
    for (int index : triangles_) {
        const cloth::MembraneTriangle& t = model_.triangles[index];
        const auto f = cloth::deformationGradient(t, placeOf(t.particles[0], x), placeOf(t.particles[1], x),
                                                  placeOf(t.particles[2], x));
        const cloth::Stretch stretch(f);
        const cloth::Symmetric2 e = stretch.strain();
        const cloth::TensionCurves& curves = t.tension >= 0 ? model_.tensionCurves[t.tension] : linear;
        const auto& c = t.stiffness;
        const double c11 = c.c11 * cloth::tensionSecant(curves.weft, e.xx),
                     c22 = c.c22 * cloth::tensionSecant(curves.warp, e.yy);
        // ½(C11 − C12²/C22)·E_xx² + ½C22·(E_yy + r·E_xx)² + ½C33·γ², r = C12/C22: three independent constraints
        const double r = c22 > 0 ? c.c12 / c22 : 0;
        const std::array<double, 3> values{e.xx, e.yy + r * e.xx, 2 * e.xy};
        const std::array<double, 3> stiffness{t.area * (c11 - r * c.c12), t.area * c22, t.area * c.c33};
        const std::array<cloth::Symmetric2, 3> directions{{{1, 0, 0}, {r, 1, 0}, {0, 0, 1}}};
        const cloth::CornerWeights w = cloth::cornerWeights(t);
        std::array<std::array<Vec3, 3>, 3> gradients;
        for (int k = 0; k < 3; ++k) {
            const cloth::Symmetric2 z = stretch.solve(directions[k]);
            const Vec3 u = 2 * (f.u * z.xx + f.v * z.xy), v = 2 * (f.u * z.xy + f.v * z.yy);
            for (int i = 0; i < 3; ++i) gradients[k][i] = w.u[i] * u + w.v[i] * v;
        }
        solveBlock<3, 3>(x, t.particles, values, gradients, stiffness);
    }
}

void JointSweep::applyCells(std::span<Place> x) const {
    static const cloth::TensionCurves linear;
    for (int index : cells_) {
        const cloth::MembraneCell& cell = model_.cells[index];
        std::array<Vec3, 4> corners;
        for (int i = 0; i < 4; ++i) corners[i] = placeOf(cell.particles[i], x);
        const cloth::CellSides sides = cloth::cellSides(cell, corners);
        std::array<Vec3, 4> direction;
        std::array<double, 4> strain;
        for (int s = 0; s < 4; ++s) {
            const double length = geometry::length(sides[s]);
            direction[s] = length > 0 ? sides[s] / length : Vec3{};
            strain[s] = length - 1;
        }
        const Vec3 xu = 0.5 * (sides[0] + sides[1]), xv = 0.5 * (sides[2] + sides[3]);
        const double weft = 0.5 * (strain[0] + strain[1]), warp = 0.5 * (strain[2] + strain[3]);
        const cloth::TensionCurves& curves = cell.tension >= 0 ? model_.tensionCurves[cell.tension] : linear;
        const auto& c = cell.stiffness;
        const double area = cell.width * cell.height;
        const double c11 = c.c11 * cloth::tensionSecant(curves.weft, weft),
                     c22 = c.c22 * cloth::tensionSecant(curves.warp, warp);
        const double r = c22 > 0 ? c.c12 / c22 : 0;
        // Mean strains as in the triangle, half differences of opposite sides, and the shear: independent again.
        const std::array<double, 5> values{weft, warp + r * weft, 0.5 * (strain[0] - strain[1]),
                                           0.5 * (strain[2] - strain[3]), dot(xu, xv)};
        const std::array<double, 5> stiffness{area * (c11 - r * c.c12), area * c22, area * c11, area * c22,
                                              area * c.c33};
        const Vec3 none;
        const Vec3 bySide[5][4] = {
            {0.5 * direction[0], 0.5 * direction[1], none, none},
            {0.5 * r * direction[0], 0.5 * r * direction[1], 0.5 * direction[2], 0.5 * direction[3]},
            {0.5 * direction[0], -0.5 * direction[1], none, none},
            {none, none, 0.5 * direction[2], -0.5 * direction[3]},
            {0.5 * xv, 0.5 * xv, 0.5 * xu, 0.5 * xu},
        };
        const double u = 1 / cell.width, v = 1 / cell.height;
        std::array<std::array<Vec3, 4>, 5> gradients;
        for (int k = 0; k < 5; ++k) { // as cloth::sideWeights has it
            const Vec3 lower = u * bySide[k][0], upper = u * bySide[k][1];
            const Vec3 left = v * bySide[k][2], right = v * bySide[k][3];
            gradients[k] = {-lower - left, lower - right, upper + right, left - upper};
        }
        solveBlock<5, 4>(x, cell.particles, values, gradients, stiffness);
    }
}

std::size_t JointSweep::bytes() const {
    const auto of = [](const auto& v) { return v.capacity() * sizeof(v[0]); };
    return of(slaveOf_) + of(expanded_) + of(terms_) + of(triangles_) + of(cells_) + of(hinges_);
}

} // namespace toile::dynamics
