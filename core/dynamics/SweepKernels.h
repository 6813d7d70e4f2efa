// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/SweepElements.h"

#include <span>

namespace toile::dynamics {

/// The loops of a sweep, compiled for one kind of processor. All kinds give the same bits: they round each operation
/// in the same order and fuse none.
struct SweepKernels {
    void (*springs)(Place* places, std::span<const FourSprings> springs);
    void (*threePoint)(Place* places, std::span<const Linear<3>> stencils);
    void (*fourPoint)(Place* places, std::span<const Linear<4>> stencils);
};

/// For every processor.
[[nodiscard]] const SweepKernels& plainKernels();
/// For processors with AVX2; null if this is none.
[[nodiscard]] const SweepKernels* avx2Kernels();

[[nodiscard]] inline const SweepKernels& fastestKernels() {
    return avx2Kernels() ? *avx2Kernels() : plainKernels();
}

} // namespace toile::dynamics
