// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/study/Accuracy.h"
#include "core/study/Circumstances.h"

#include <vector>

namespace toile::study {

/// One record a run, as validation.md section 3 has it; keys that do not apply are absent.
[[nodiscard]] std::vector<Json> recordsOf(const CaseResult& result, const Circumstances& circumstances);

/// What the records of a case will be known by before it is run: "scene" and "method" of each.
[[nodiscard]] std::vector<Json> keysOf(const AccuracyCase& which);

/// The result that these records of the case were written from, in the order of its setups. Trajectories and what is
/// not in a record stay empty.
[[nodiscard]] CaseResult resultFrom(const AccuracyCase& which, const std::vector<Json>& records);

} // namespace toile::study
