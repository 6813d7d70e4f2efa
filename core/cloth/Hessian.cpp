// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/Contracts.h"
#include "core/cloth/FoldAngle.h"
#include "core/cloth/Forces.h"
#include "core/cloth/MembraneCellForces.h"
#include "core/cloth/TriangleForces.h"

#include <Eigen/Dense>
#include <algorithm>

namespace toile::cloth {
namespace {

using Positions = std::span<const Vec3>;

/// Leaves out the negative part of a symmetric matrix.
template <int N>
void project(Eigen::Matrix<double, N, N>& matrix) {
    using Matrix = Eigen::Matrix<double, N, N>;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver(matrix);
    if (solver.eigenvalues()[0] >= 0) return;
    matrix = solver.eigenvectors() * solver.eigenvalues().cwiseMax(0).asDiagonal() * solver.eigenvectors().transpose();
}

void addSprings(const std::vector<Spring>& springs, Positions x, HessianForm form, HessianSink& sink) {
    for (const Spring& s : springs) {
        const Vec3 d = x[s.b] - x[s.a];
        const double length = geometry::length(d);
        const Vec3 n = length > 0 ? d / length : Vec3{};
        double across = length > 0 ? 1 - s.restLength / length : 1;
        if (form == HessianForm::projected) across = std::max(0.0, across);
        double block[9], opposite[9];
        for (int p = 0; p < 3; ++p)
            for (int q = 0; q < 3; ++q) {
                block[3 * p + q] = s.stiffness * ((1 - across) * n[p] * n[q] + (p == q ? across : 0));
                opposite[3 * p + q] = -block[3 * p + q];
            }
        sink.add(s.a, s.a, block);
        sink.add(s.b, s.b, block);
        sink.add(s.a, s.b, opposite);
        sink.add(s.b, s.a, opposite);
    }
}

void addStencils(const std::vector<Stencil>& stencils, HessianSink& sink) {
    for (const Stencil& s : stencils)
        for (int i = 0; i < 4 && s.particles[i] >= 0; ++i)
            for (int j = 0; j < 4 && s.particles[j] >= 0; ++j) {
                const double k = s.stiffness * s.coefficients[i] * s.coefficients[j];
                const double block[9] = {k, 0, 0, 0, k, 0, 0, 0, k};
                sink.add(s.particles[i], s.particles[j], block);
            }
}

/// Adds an element's Hessian over `count` vectors v = Σ weights[v][corner]·x(corner), given column-major.
template <int Vectors, int Corners, class Weights>
void addMapped(const std::array<int, Corners>& particles, const Weights& weights,
               const Eigen::Matrix<double, 3 * Vectors, 3 * Vectors>& h, HessianSink& sink) {
    for (int i = 0; i < Corners; ++i)
        for (int j = 0; j < Corners; ++j) {
            Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
            for (int s = 0; s < Vectors; ++s)
                for (int t = 0; t < Vectors; ++t) {
                    const double w = weights[s][i] * weights[t][j];
                    if (w != 0) sum += w * h.template block<3, 3>(3 * s, 3 * t);
                }
            double block[9];
            Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(block, 3, 3) = sum;
            sink.add(particles[i], particles[j], block);
        }
}

void addTriangle(const ClothModel& model, const MembraneTriangle& t, Positions x, HessianForm form, HessianSink& sink) {
    const auto f = deformationGradient(t, x[t.particles[0]], x[t.particles[1]], x[t.particles[2]]);
    const auto values = triangleHessian(model, t, f);
    Eigen::Matrix<double, 6, 6> h = Eigen::Map<const Eigen::Matrix<double, 6, 6>>(values.data());
    if (form == HessianForm::projected) project(h);
    const CornerWeights w = cornerWeights(t);
    addMapped<2, 3>(t.particles, std::array{w.u, w.v}, h, sink);
}

void addCell(const ClothModel& model, const MembraneCell& c, Positions x, HessianForm form, HessianSink& sink) {
    const CellSides sides = cellSides(c, {x[c.particles[0]], x[c.particles[1]], x[c.particles[2]], x[c.particles[3]]});
    const auto values = cellHessian(model, c, sides);
    Eigen::Matrix<double, 12, 12> h = Eigen::Map<const Eigen::Matrix<double, 12, 12>>(values.data());
    if (form == HessianForm::projected) project(h);
    addMapped<4, 4>(c.particles, sideWeights(c), h, sink);
}

/// Second derivative of the fold angle: the change of its gradient for one unit of change in each coordinate.
Eigen::Matrix<double, 12, 12> angleHessian(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 e = b - a, p = c - a, q = d - a, n1 = cross(e, p), n2 = cross(q, e);
    const double ee = squaredLength(e), length = std::sqrt(ee), n1n1 = squaredLength(n1), n2n2 = squaredLength(n2);
    const Vec3 atC = n1 * (length / n1n1), atD = n2 * (length / n2n2);
    const double s = dot(p, e) / ee, t = dot(q, e) / ee;
    Eigen::Matrix<double, 12, 12> h;
    for (int column = 0; column < 12; ++column) {
        Vec3 change[4];
        change[column / 3][column % 3] = 1;
        const Vec3 de = change[1] - change[0], dp = change[2] - change[0], dq = change[3] - change[0];
        const Vec3 dn1 = cross(de, p) + cross(e, dp), dn2 = cross(dq, e) + cross(q, de);
        const double dLength = dot(e, de) / length;
        const auto changed = [&](const Vec3& n, double nn, const Vec3& dn) {
            return n * (dLength / nn) + (dn - n * (2 * dot(n, dn) / nn)) * (length / nn);
        };
        const Vec3 dAtC = changed(n1, n1n1, dn1), dAtD = changed(n2, n2n2, dn2);
        const double ds = (dot(dp, e) + dot(p, de) - 2 * s * dot(e, de)) / ee;
        const double dt = (dot(dq, e) + dot(q, de) - 2 * t * dot(e, de)) / ee;
        const Vec3 rows[4] = {dAtC * (s - 1) + atC * ds + dAtD * (t - 1) + atD * dt,
                              -s * dAtC - ds * atC - t * dAtD - dt * atD, dAtC, dAtD};
        for (int i = 0; i < 12; ++i) h(i, column) = rows[i / 3][i % 3];
    }
    return h;
}

void addHinge(const Hinge& hinge, Positions x, HessianForm form, HessianSink& sink) {
    const std::array<int, 4> particles{hinge.a, hinge.b, hinge.c, hinge.d};
    const Vec3 &a = x[hinge.a], &b = x[hinge.b], &c = x[hinge.c], &d = x[hinge.d];
    const FoldAngle fold = foldAngle(a, b, c, d);
    if (fold.gradient[2] == Vec3{}) return; // a triangle without a plane bends nothing
    Eigen::Matrix<double, 12, 1> gradient;
    for (int i = 0; i < 12; ++i) gradient[i] = fold.gradient[i / 3][i % 3];
    Eigen::Matrix<double, 12, 12> h = hinge.stiffness * gradient * gradient.transpose();
    if (form == HessianForm::exact)
        h += hinge.stiffness * angleFrom(hinge.restAngle, fold.angle) * angleHessian(a, b, c, d);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            double block[9];
            Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(block, 3, 3) = h.block<3, 3>(3 * i, 3 * j);
            sink.add(particles[i], particles[j], block);
        }
}

} // namespace

void addHessian(const ClothModel& model, Positions x, HessianForm form, HessianSink& sink) {
    expects(x.size() == model.mass.size(), "one position per particle");
    for (const auto* springs : {&model.structural, &model.shear, &model.elastics, &model.flexion})
        addSprings(*springs, x, form, sink);
    for (const auto* stencils : {&model.bending, &model.twist}) addStencils(*stencils, sink);
    for (const Hinge& h : model.hinges) addHinge(h, x, form, sink);
    for (const MembraneTriangle& t : model.triangles) addTriangle(model, t, x, form, sink);
    for (const MembraneCell& c : model.cells) addCell(model, c, x, form, sink);
}

} // namespace toile::cloth
