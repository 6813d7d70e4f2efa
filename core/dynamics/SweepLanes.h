// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Four numbers at once. Compiled once for each kind of processor by the files that include it, hence without names
// that another file could see.

#include "core/dynamics/SweepElements.h"

#include <cmath>

#pragma GCC diagnostic ignored "-Wpsabi" // all of it is inlined

namespace toile::dynamics {
namespace {

#define TOILE_LANES [[gnu::always_inline]] inline

using Four = double __attribute__((vector_size(32)));
using FourFlags = decltype(Four{} < Four{});

TOILE_LANES Four all(double value) {
    return Four{value, value, value, value};
}

using FourInMemory [[gnu::may_alias]] = Four;

TOILE_LANES Four load(const Place& place) {
    return *reinterpret_cast<const FourInMemory*>(&place);
}

TOILE_LANES void store(Place& place, Four value) {
    *reinterpret_cast<FourInMemory*>(&place) = value;
}

TOILE_LANES Four load(const std::array<double, 4>& values) { // aligned to 32 bytes
    return *reinterpret_cast<const FourInMemory*>(values.data());
}

TOILE_LANES Four squareRoot(Four v) {
#if defined(TOILE_AVX2)
    return _mm256_sqrt_pd(v);
#else
    return Four{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
#endif
}

/// Rows to columns: x, y and z of four vectors.
TOILE_LANES void transpose(Four a, Four b, Four c, Four d, Four& x, Four& y, Four& z) {
    const Four abXZ = __builtin_shufflevector(a, b, 0, 4, 2, 6), abY = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Four cdXZ = __builtin_shufflevector(c, d, 0, 4, 2, 6), cdY = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    x = __builtin_shufflevector(abXZ, cdXZ, 0, 1, 4, 5);
    y = __builtin_shufflevector(abY, cdY, 0, 1, 4, 5);
    z = __builtin_shufflevector(abXZ, cdXZ, 2, 3, 6, 7);
}

} // namespace
} // namespace toile::dynamics
