// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/ConjugateGradient.h"

#include "core/dynamics/BlockVectors.h"

#include <Eigen/Dense>
#include <algorithm>

namespace toile::dynamics {
namespace {

using Block = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

/// Inverses of the diagonal blocks; empty if one is not positive definite.
std::vector<Block> invertedDiagonal(const BlockMatrix& matrix, std::span<const double> shift) {
    std::vector<Block> inverses(matrix.blockCount());
    for (std::size_t place = 0; place < matrix.pattern().size(); ++place) {
        const auto key = matrix.pattern()[place];
        const int row = BlockMatrix::rowOf(key);
        if (row != BlockMatrix::columnOf(key)) continue;
        Block block = Eigen::Map<const Block>(matrix.block(place));
        block.diagonal().array() += shift[row];
        const Eigen::LLT<Block> factor(block);
        if (factor.info() != Eigen::Success) return {};
        inverses[row] = factor.solve(Block::Identity());
    }
    return inverses;
}

void precondition(const std::vector<Block>& inverses, std::span<const Vec3> r, std::span<Vec3> z) {
    for (std::size_t i = 0; i < r.size(); ++i) {
        const double* a = inverses[i].data();
        z[i] = {a[0] * r[i].x + a[1] * r[i].y + a[2] * r[i].z, a[3] * r[i].x + a[4] * r[i].y + a[5] * r[i].z,
                a[6] * r[i].x + a[7] * r[i].y + a[8] * r[i].z};
    }
}

} // namespace

GradientReport conjugateGradient(const BlockMatrix& matrix, std::span<const double> shift, std::span<const Vec3> b,
                                 double tolerance, int maximumIterations, std::vector<Vec3>& x, std::stop_token stop) {
    GradientReport report;
    x.assign(b.size(), {});
    const std::vector<Block> inverses = invertedDiagonal(matrix, shift);
    if (inverses.empty() && !b.empty()) return {GradientEnd::indefinite, 0};
    std::vector<Vec3> r(b.begin(), b.end()), z(b.size()), p(b.size()), ap(b.size());
    precondition(inverses, r, z);
    p = z;
    double rz = dotOf(r, z);
    for (; largestOf(r) > tolerance; ++report.iterations) {
        if (report.iterations == maximumIterations || stop.stop_requested())
            return {GradientEnd::tooMany, report.iterations};
        matrix.multiply(shift, p, ap);
        const double curvature = dotOf(p, ap);
        if (!(curvature > 0)) return {GradientEnd::indefinite, report.iterations};
        const double step = rz / curvature;
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += step * p[i];
            r[i] -= step * ap[i];
        }
        precondition(inverses, r, z);
        const double next = dotOf(r, z), turn = next / rz;
        rz = next;
        for (std::size_t i = 0; i < p.size(); ++i) p[i] = z[i] + turn * p[i];
    }
    return report;
}

} // namespace toile::dynamics
