// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The loops of a sweep. Compiled once for each kind of processor by the files that include it.

#include "core/dynamics/SweepKernels.h"
#include "core/dynamics/SweepLanes.h"

namespace toile::dynamics {
namespace {

constexpr double shortest = 1e-12; ///< [m]; a shorter spring has no direction of its own

void sweepSprings(Place* places, std::span<const FourSprings> springs) {
    for (const FourSprings& s : springs) {
        Four d[4], squares[4], xx, yy, zz;
        for (int i = 0; i < 4; ++i) {
            d[i] = load(places[s.b[i]]) - load(places[s.a[i]]);
            squares[i] = d[i] * d[i];
        }
        transpose(squares[0], squares[1], squares[2], squares[3], xx, yy, zz);
        Four length = squareRoot(xx + yy + zz);
        for (int i = 0; i < 4; ++i)
            if (length[i] < shortest) [[unlikely]] {
                d[i] = Four{0, shortest, 0, 0}; // any fixed direction parts two particles in one place
                length[i] = shortest;
            }
        const Four excess = (length - load(s.restLength)) / length;
        for (int i = 0; i < 4; ++i) {
            const Four change = all(excess[i]) * d[i];
            store(places[s.a[i]], load(places[s.a[i]]) + all(s.correctionA[i]) * change);
            store(places[s.b[i]], load(places[s.b[i]]) - all(s.correctionB[i]) * change);
        }
    }
}

template <int N>
void sweepLinear(Place* places, std::span<const Linear<N>> stencils) {
    for (const Linear<N>& s : stencils) {
        Four x[N], value{};
        for (int i = 0; i < N; ++i) {
            x[i] = load(places[s.particles[i]]);
            value += all(s.coefficients[i]) * x[i];
        }
        for (int i = 0; i < N; ++i) store(places[s.particles[i]], x[i] - all(s.corrections[i]) * value);
    }
}

constexpr SweepKernels kernels{sweepSprings, sweepLinear<3>, sweepLinear<4>};

} // namespace
} // namespace toile::dynamics
