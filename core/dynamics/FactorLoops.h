// SPDX-License-Identifier: GPL-3.0-or-later
// The loops of a solution with a factor. Compiled once for each kind of processor by Kernels.cpp and KernelsAvx2.cpp.
#ifdef TOILE_FACTOR_LOOPS
#error "Two kinds of processor in one compilation would be the same one."
#endif
#define TOILE_FACTOR_LOOPS

#include "core/dynamics/FactorKernels.h"
#include "core/dynamics/Lanes.h"

namespace toile::dynamics {
namespace {

TOILE_LANES FourAnywhere& lanesAt(double* x) {
    return *reinterpret_cast<FourAnywhere*>(x);
}
TOILE_LANES Four lanesAt(const float* values) {
    return __builtin_convertvector(*reinterpret_cast<const FourFloatsAnywhere*>(values), Four);
}

/// `Width` columns from `column` on: solved for among themselves, and taken off the rows below.
template <int Width>
void forwardColumns(const FactorPanel& panel, int column, double* x) {
    const std::int64_t stride = panel.rows;
    const float* const values = panel.values + column * stride;
    for (int p = 0; p < Width; ++p) {
        x[column + p] /= values[p * stride + column + p];
        for (int q = p + 1; q < Width; ++q) x[column + q] -= values[p * stride + column + q] * x[column + p];
    }
    Four solved[Width];
    for (int p = 0; p < Width; ++p) solved[p] = all(x[column + p]);
    int row = column + Width;
    for (; row + 4 <= panel.rows; row += 4) {
        Four sum = solved[0] * lanesAt(values + row);
        for (int p = 1; p < Width; ++p) sum += solved[p] * lanesAt(values + p * stride + row);
        lanesAt(x + row) -= sum;
    }
    for (; row < panel.rows; ++row) {
        double sum = solved[0][0] * values[row];
        for (int p = 1; p < Width; ++p) sum += solved[p][0] * values[p * stride + row];
        x[row] -= sum;
    }
}

template <int Width>
void backwardColumns(const FactorPanel& panel, int column, double* x) {
    const std::int64_t stride = panel.rows;
    const float* const values = panel.values + column * stride;
    Four sums[Width] = {};
    int row = column + Width;
    for (; row + 4 <= panel.rows; row += 4)
        for (int p = 0; p < Width; ++p) sums[p] += lanesAt(values + p * stride + row) * lanesAt(x + row);
    for (; row < panel.rows; ++row)
        for (int p = 0; p < Width; ++p) sums[p][0] += values[p * stride + row] * x[row];
    for (int p = Width - 1; p >= 0; --p) {
        double sum = (sums[p][0] + sums[p][1]) + (sums[p][2] + sums[p][3]);
        for (int q = p + 1; q < Width; ++q) sum += values[p * stride + column + q] * x[column + q];
        x[column + p] = (x[column + p] - sum) / values[p * stride + column + p];
    }
}

void forward(const FactorPanel& panel, double* x) {
    int column = 0;
    for (; column + 6 <= panel.columns; column += 6) forwardColumns<6>(panel, column, x);
    for (; column + 3 <= panel.columns; column += 3) forwardColumns<3>(panel, column, x);
    for (; column < panel.columns; ++column) forwardColumns<1>(panel, column, x);
}

void backward(const FactorPanel& panel, double* x) {
    int column = panel.columns;
    for (; column >= 6; column -= 6) backwardColumns<6>(panel, column - 6, x);
    for (; column >= 3; column -= 3) backwardColumns<3>(panel, column - 3, x);
    for (; column > 0; --column) backwardColumns<1>(panel, column - 1, x);
}

constexpr FactorKernels factorKernels{forward, backward};

} // namespace
} // namespace toile::dynamics
