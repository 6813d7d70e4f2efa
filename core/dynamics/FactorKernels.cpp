// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/FactorLoops.h"

namespace toile::dynamics {

const FactorKernels& plainFactorKernels() {
    return kernels;
}

} // namespace toile::dynamics
