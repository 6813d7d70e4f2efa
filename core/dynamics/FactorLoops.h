// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The loops of a solution with a factor. Compiled once for each kind of processor by the files that include it.

#include "core/dynamics/FactorKernels.h"

#include <cstdint>

#pragma GCC diagnostic ignored "-Wpsabi" // all of it is inlined

namespace toile::dynamics {
namespace {

constexpr int laneCount = 4;
using Lanes = double __attribute__((vector_size(32)));
using LanesAnywhere [[gnu::may_alias]] = double __attribute__((vector_size(32), aligned(8)));
using FloatsAnywhere [[gnu::may_alias]] = float __attribute__((vector_size(16), aligned(4)));

[[gnu::always_inline]] inline LanesAnywhere& lanesAt(double* x) {
    return *reinterpret_cast<LanesAnywhere*>(x);
}
[[gnu::always_inline]] inline Lanes lanesAt(const float* values) {
    return __builtin_convertvector(*reinterpret_cast<const FloatsAnywhere*>(values), Lanes);
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
    Lanes solved[Width];
    for (int p = 0; p < Width; ++p) {
        const double value = x[column + p];
        solved[p] = Lanes{value, value, value, value};
    }
    int row = column + Width;
    for (; row + laneCount <= panel.rows; row += laneCount) {
        Lanes sum = solved[0] * lanesAt(values + row);
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
    Lanes sums[Width] = {};
    int row = column + Width;
    for (; row + laneCount <= panel.rows; row += laneCount)
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

constexpr FactorKernels kernels{forward, backward};

} // namespace
} // namespace toile::dynamics
