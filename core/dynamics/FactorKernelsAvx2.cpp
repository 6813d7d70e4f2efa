// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/FactorKernels.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <cstdint>
// From here on, so that nothing inline of the headers above is compiled for AVX2 and taken for all processors.
#pragma GCC target("avx2")
#include "core/dynamics/FactorLoops.h"

namespace toile::dynamics {

const FactorKernels* avx2FactorKernels() {
    static const bool supported = __builtin_cpu_supports("avx2");
    return supported ? &kernels : nullptr;
}

} // namespace toile::dynamics
#else
namespace toile::dynamics {

const FactorKernels* avx2FactorKernels() {
    return nullptr;
}

} // namespace toile::dynamics
#endif
