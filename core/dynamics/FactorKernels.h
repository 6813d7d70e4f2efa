// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace toile::dynamics {

/// The columns of a supernode, one after the other; the upper triangle of the first `columns` rows is not read.
struct FactorPanel {
    const float* values = nullptr;
    int rows = 0, columns = 0;
};

/// What a solution does with one supernode, compiled for one kind of processor. All kinds give the same bits. x has an
/// entry for each row of the panel; the first are those of its own columns.
struct FactorKernels {
    void (*forward)(const FactorPanel& panel, double* x);  ///< own ← L⁻¹ own, then the others −= L own
    void (*backward)(const FactorPanel& panel, double* x); ///< own ← L⁻ᵀ (own − Lᵀ others)
};

/// For every processor.
[[nodiscard]] const FactorKernels& plainFactorKernels();
/// For processors with AVX2; null if this is none.
[[nodiscard]] const FactorKernels* avx2FactorKernels();

[[nodiscard]] inline const FactorKernels& fastestFactorKernels() {
    return avx2FactorKernels() ? *avx2FactorKernels() : plainFactorKernels();
}

} // namespace toile::dynamics
