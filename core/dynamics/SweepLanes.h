// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Places, and four vectors, at once.

#include "core/dynamics/Lanes.h"
#include "core/dynamics/SweepElements.h"

#include <array>
#include <cmath>

namespace toile::dynamics {
namespace {

TOILE_LANES Four load(const Place& place) {
    return *reinterpret_cast<const FourInMemory*>(&place);
}

TOILE_LANES void store(Place& place, Four value) {
    *reinterpret_cast<FourInMemory*>(&place) = value;
}

TOILE_LANES Four load(const FourNumbers& values) {
    return *reinterpret_cast<const FourAnywhere*>(values.data());
}

TOILE_LANES Four load(const std::array<float, 4>& values) { // aligned to 16 bytes
    return __builtin_convertvector(*reinterpret_cast<const FourFloats*>(values.data()), Four);
}

TOILE_LANES FourNumbers numbers(Four v) {
    return {v[0], v[1], v[2], v[3]};
}

TOILE_LANES Four squareRoot(Four v) {
#if defined(TOILE_AVX2)
    return _mm256_sqrt_pd(v);
#else
    return Four{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])};
#endif
}

TOILE_LANES Four larger(Four a, Four b) {
    return a < b ? b : a;
}

TOILE_LANES bool any(FourFlags flags) {
#if defined(TOILE_AVX2)
    return !_mm256_testz_si256(reinterpret_cast<__m256i>(flags), reinterpret_cast<__m256i>(flags));
#else
    return flags[0] | flags[1] | flags[2] | flags[3];
#endif
}

/// The vector of a place, without its inverse mass.
TOILE_LANES Four vectorOf(Four v) {
    return reinterpret_cast<Four>(reinterpret_cast<FourFlags>(v) & FourFlags{-1, -1, -1, 0});
}

TOILE_LANES Four inverseMassOf(Four place) {
    return __builtin_shufflevector(place, place, 3, 3, 3, 3);
}

/// Rows to columns.
TOILE_LANES void transpose(Four& a, Four& b, Four& c, Four& d) {
    const Four ab02 = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab13 = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Four cd02 = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd13 = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    a = __builtin_shufflevector(ab02, cd02, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab13, cd13, 0, 1, 4, 5);
    c = __builtin_shufflevector(ab02, cd02, 2, 3, 6, 7);
    d = __builtin_shufflevector(ab13, cd13, 2, 3, 6, 7);
}

/// Four vectors.
struct Vectors {
    Four x{}, y{}, z{};
};

TOILE_LANES Vectors operator+(const Vectors& a, const Vectors& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
TOILE_LANES Vectors operator-(const Vectors& a, const Vectors& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
TOILE_LANES Vectors operator*(const Vectors& a, Four s) {
    return {a.x * s, a.y * s, a.z * s};
}
TOILE_LANES Four dot(const Vectors& a, const Vectors& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
TOILE_LANES Vectors cross(const Vectors& a, const Vectors& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The same corner of four elements.
struct Corners {
    Vectors at;
    Four inverseMass{};
};

TOILE_LANES Corners gather(const Place* places, const FourIndices& particles) {
    Four rows[4];
    for (int i = 0; i < 4; ++i) rows[i] = load(places[particles[i]]);
    transpose(rows[0], rows[1], rows[2], rows[3]);
    return {{rows[0], rows[1], rows[2]}, rows[3]};
}

TOILE_LANES void scatter(Place* places, const FourIndices& particles, const Corners& corners) {
    Four rows[4] = {corners.at.x, corners.at.y, corners.at.z, corners.inverseMass};
    transpose(rows[0], rows[1], rows[2], rows[3]);
    for (int i = 0; i < 4; ++i) store(places[particles[i]], rows[i]);
}

} // namespace
} // namespace toile::dynamics
