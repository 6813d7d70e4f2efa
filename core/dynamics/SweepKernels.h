// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/dynamics/SweepElements.h"

#include <span>

namespace toile::dynamics {

/// The loops of a sweep, compiled for one kind of processor. All kinds give the same bits: they round each operation
/// in the same order and fuse none.
struct SweepKernels {
    void (*springs)(Place* places, std::span<const FourSprings> springs);
    void (*threePoint)(Place* places, std::span<const LinearElement<3>> stencils);
    void (*fourPoint)(Place* places, std::span<const LinearElement<4>> stencils);
    /// cap as in XpbdSettings; the law knows the first of these fours as number `first`, or is empty where all is
    /// linear.
    void (*triangles)(Place* places, std::span<const FourTriangles> triangles, double cap, const TensionLaw& law,
                      int first);
    void (*cells)(Place* places, std::span<const FourCells> cells, double cap, const TensionLaw& law, int first);
    void (*hinges)(Place* places, std::span<const FourHinges> hinges, double cap);
    void (*level)(Place* places, std::span<const FourLevelTriangles> triangles);
};

/// For every processor.
[[nodiscard]] const SweepKernels& plainKernels();
/// For processors with AVX2; null if this is none.
[[nodiscard]] const SweepKernels* avx2Kernels();

[[nodiscard]] inline const SweepKernels& fastestKernels() {
    return avx2Kernels() ? *avx2Kernels() : plainKernels();
}

} // namespace toile::dynamics
