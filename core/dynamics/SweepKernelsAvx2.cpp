// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/SweepKernels.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <cmath>
#include <cstdint>
#include <immintrin.h>
#include <limits>
#include <numbers>
// From here on, so that nothing inline of the headers above is compiled for AVX2 and taken for all processors.
#pragma GCC target("avx2")
#define TOILE_AVX2
#include "core/dynamics/SweepLoops.h"

namespace toile::dynamics {

const SweepKernels* avx2Kernels() {
    static const bool supported = __builtin_cpu_supports("avx2");
    return supported ? &kernels : nullptr;
}

} // namespace toile::dynamics
#else
namespace toile::dynamics {

const SweepKernels* avx2Kernels() {
    return nullptr;
}

} // namespace toile::dynamics
#endif
