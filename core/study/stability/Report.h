// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/study/Circumstances.h"
#include "core/study/stability/Cases.h"

namespace toile::study::stability {

/// "S3    button on silk …   PASS  growth 1e-4 …": for the terminal.
[[nodiscard]] std::string lineOf(const Row& row);

/// "31 PASS, 2 PASS-WARN, 9 REFUSED, 3 FAIL": rows by verdict.
[[nodiscard]] std::string summaryOf(const std::vector<Row>& rows);

/// The table in Markdown, and the map's picture if there is one.
[[nodiscard]] std::string stabilityText(const std::vector<Row>& rows, bool withMap, const Circumstances& circumstances);

/// One record a row, one a cell of the map.
[[nodiscard]] std::vector<Json> recordsOf(const std::vector<Row>& rows, const std::vector<MapCell>& map,
                                          const Circumstances& circumstances);

} // namespace toile::study::stability
