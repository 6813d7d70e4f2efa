// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/PaperSprings.h"

#include "core/base/Contracts.h"
#include "core/cloth/Flexion.h"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace toile::cloth {
namespace {

/// A symmetric stiffness tensor by its six constants in an orthonormal basis (Mandel): distances between tensors do not
/// depend on the axes.
using SixConstants = Eigen::Vector<double, 6>;

constexpr double root2 = 1.4142135623730951;

/// Of a spring of stiffness 1 along a side (x, y), over the area of the triangle: ½·(change of length)² for a strain.
SixConstants constantsAlong(double x, double y) {
    const double squared = x * x + y * y;
    const Eigen::Vector3d n(x * x / squared, y * y / squared, root2 * x * y / squared);
    const Eigen::Matrix3d c = squared * n * n.transpose();
    return {c(0, 0), c(1, 1), c(2, 2), root2 * c(0, 1), root2 * c(0, 2), root2 * c(1, 2)};
}

SixConstants constantsOf(const MembraneTriangle& t) {
    const material::MembraneStiffness& c = t.stiffness;
    return t.area * SixConstants(c.c11, c.c22, 2 * c.c33, root2 * c.c12, 0, 0);
}

struct TriangleSides {
    std::array<Vec2, 3> along; ///< side i joins corners i and i + 1 [m]
    Eigen::Matrix<double, 6, 3> constants;
};

TriangleSides sidesOf(const MembraneTriangle& t) {
    const auto& [a, b, c, d] = t.inverseRest;
    const double determinant = a * d - b * c;
    const Vec2 first{d / determinant, -c / determinant}, second{-b / determinant, a / determinant}; // columns
    TriangleSides sides{{first, second - first, -second}, {}};
    for (int i = 0; i < 3; ++i) sides.constants.col(i) = constantsAlong(sides.along[i].x, sides.along[i].y);
    return sides;
}

/// Non-negative least squares of three unknowns: the best of the eight solutions in which some are 0.
Eigen::Vector3d nonNegativeFit(const Eigen::Matrix<double, 6, 3>& columns, const SixConstants& wanted) {
    Eigen::Vector3d best = Eigen::Vector3d::Zero();
    double least = wanted.squaredNorm();
    for (int used = 1; used < 8; ++used) {
        Eigen::Matrix<double, 6, Eigen::Dynamic> some(6, 0);
        std::array<int, 3> which{};
        for (int i = 0; i < 3; ++i) {
            if (!(used & 1 << i)) continue;
            which[some.cols()] = i;
            some.conservativeResize(6, some.cols() + 1);
            some.rightCols(1) = columns.col(i);
        }
        const Eigen::VectorXd k = some.colPivHouseholderQr().solve(wanted);
        const double rest = (some * k - wanted).squaredNorm();
        if (k.minCoeff() < 0 || rest >= least) continue;
        least = rest;
        best.setZero();
        for (int i = 0; i < k.size(); ++i) best[which[i]] = k[i];
    }
    return best;
}

double residualOf(const MembraneTriangle& t, const std::array<Spring, 3>& springs) {
    const TriangleSides sides = sidesOf(t);
    SixConstants left = constantsOf(t);
    const double norm = left.norm();
    for (int i = 0; i < 3; ++i) left -= springs[i].stiffness * sides.constants.col(i);
    return left.norm() / norm;
}

} // namespace

std::array<Spring, 3> springsInsteadOf(const MembraneTriangle& triangle) {
    const TriangleSides sides = sidesOf(triangle);
    const Eigen::Vector3d k = nonNegativeFit(sides.constants, constantsOf(triangle));
    std::array<Spring, 3> springs;
    for (int i = 0; i < 3; ++i)
        springs[i] = {triangle.particles[i], triangle.particles[(i + 1) % 3], length(sides.along[i]), k[i]};
    return springs;
}

PaperReport springsAlone(ClothModel& model, double curvature) {
    expects(model.cells.empty(), "springs of the paper's cells, however negative they would have to be");
    PaperReport report;
    double squares = 0;
    for (const MembraneTriangle& t : model.triangles) {
        const auto springs = springsInsteadOf(t);
        for (const Spring& spring : springs)
            if (spring.stiffness > 0 && spring.a != spring.b) model.structural.push_back(spring);
        squares += std::pow(residualOf(t, springs), 2);
        ++report.triangles;
    }
    if (report.triangles > 0) report.fitResidual = std::sqrt(squares / report.triangles);
    model.triangles.clear();
    model.tensionCurves.clear();
    const FlexionReport flexion = flexionInsteadOfBending(model, curvature);
    report.flexionSprings = flexion.springs;
    report.droppedBending = flexion.dropped;
    return report;
}

} // namespace toile::cloth
