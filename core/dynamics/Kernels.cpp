// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/FactorLoops.h"
#include "core/dynamics/SweepLoops.h"

namespace toile::dynamics {

// Of KernelsAvx2.cpp, of which nothing may run before the processor was asked; null where it is not compiled.
extern const SweepKernels* const sweepKernelsForAvx2;
extern const FactorKernels* const factorKernelsForAvx2;

namespace {

bool hasAvx2() {
#if defined(__x86_64__) && defined(__GNUC__)
    static const bool supported = __builtin_cpu_supports("avx2");
    return supported;
#else
    return false;
#endif
}

} // namespace

const SweepKernels& plainKernels() {
    return sweepKernels;
}

const SweepKernels* avx2Kernels() {
    return hasAvx2() ? sweepKernelsForAvx2 : nullptr;
}

const FactorKernels& plainFactorKernels() {
    return factorKernels;
}

const FactorKernels* avx2FactorKernels() {
    return hasAvx2() ? factorKernelsForAvx2 : nullptr;
}

} // namespace toile::dynamics
