// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/study/Circumstances.h"
#include "core/study/lean/Lean.h"

namespace toile::study::lean {

/// One record a row.
[[nodiscard]] std::vector<Json> recordsOf(const FeatureResult& result, const Circumstances& circumstances);

/// What the records of a feature will be known by before it is run: "scene" and "method" of each. None where a scene
/// cannot be simulated.
[[nodiscard]] std::vector<Json> keysOf(const Feature& feature, const LeanSettings& settings);

/// The result that these records of the feature were written from, in the order of its variants; positions stay empty.
[[nodiscard]] FeatureResult resultFrom(const Feature& feature, const std::vector<Json>& records);

} // namespace toile::study::lean
