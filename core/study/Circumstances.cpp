// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/Circumstances.h"

#include <cstdlib>

namespace toile::study {

double machineLoad() {
    double load = 0;
    return getloadavg(&load, 1) == 1 ? load : 0;
}

} // namespace toile::study
