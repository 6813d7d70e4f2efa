// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/study/Circumstances.h"
#include "core/study/scenes/Case.h"

namespace toile::study::scenes {

struct Outcome {
    std::string name, about; ///< of the case
    std::vector<Row> rows;
};

/// "14 of 15 goals are reached. Missed: …"
[[nodiscard]] std::string summaryOf(const std::vector<Outcome>& outcomes);
[[nodiscard]] bool allReached(const std::vector<Outcome>& outcomes);

/// A table for each scene, in Markdown.
[[nodiscard]] std::string scenesText(const std::vector<Outcome>& outcomes, const Circumstances& circumstances);

/// One record a row.
[[nodiscard]] std::vector<Json> recordsOf(const Outcome& outcome, const Circumstances& circumstances);
/// What the records of a case will be known by before it is run: "scene" and "method" of each.
[[nodiscard]] std::vector<Json> keysOf(const Case& one);
/// The outcome that these records of the case were written from.
[[nodiscard]] Outcome outcomeFrom(const Case& one, const std::vector<Json>& records);

} // namespace toile::study::scenes
