// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Circumstances.h"
#include "core/study/GarmentAccuracy.h"

#include <vector>

namespace toile::study {

/// One record a run, and one for each setup that was not run to its end.
[[nodiscard]] std::vector<Json> recordsOf(const GarmentAccuracy& study, const Circumstances& circumstances);

} // namespace toile::study
