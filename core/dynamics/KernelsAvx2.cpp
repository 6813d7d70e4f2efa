// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/dynamics/FactorKernels.h"
#include "core/dynamics/SweepKernels.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <array>
#include <cmath>
#include <cstdint>
#include <immintrin.h>
#include <limits>
#include <numbers>
// From here on, so that nothing inline of the headers above is compiled for AVX2 and taken for all processors.
#pragma GCC target("avx2")
#define TOILE_AVX2
#include "core/dynamics/FactorLoops.h"
#include "core/dynamics/SweepLoops.h"

namespace toile::dynamics {

extern const SweepKernels* const sweepKernelsForAvx2 = &sweepKernels;
extern const FactorKernels* const factorKernelsForAvx2 = &factorKernels;

} // namespace toile::dynamics
#else
namespace toile::dynamics {

extern const SweepKernels* const sweepKernelsForAvx2 = nullptr;
extern const FactorKernels* const factorKernelsForAvx2 = nullptr;

} // namespace toile::dynamics
#endif
