// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dynamics/SweepLoops.h"

namespace toile::dynamics {

const SweepKernels& plainKernels() {
    return kernels;
}

} // namespace toile::dynamics
