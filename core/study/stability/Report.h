// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Json.h"
#include "core/study/Circumstances.h"
#include "core/study/stability/Cases.h"

namespace toile::study::stability {

/// "S3    button on silk …   PASS  growth 1e-4 …": for the terminal.
[[nodiscard]] std::string lineOf(const Row& row);

/// "31 PASS, 2 PASS-WARN, 9 REFUSED, 3 FAIL; 14 cases not run.": rows by verdict.
[[nodiscard]] std::string summaryOf(const std::vector<Row>& rows, const std::vector<NotRun>& notRun);

/// The table in Markdown, with what was not run, and the map's picture if there is one.
[[nodiscard]] std::string stabilityText(const std::vector<Row>& rows, const std::vector<NotRun>& notRun, bool withMap,
                                        const Circumstances& circumstances);

/// One record a row, one a cell of the map, one for each case that was not run.
[[nodiscard]] std::vector<Json> recordsOf(const std::vector<Row>& rows, const std::vector<MapCell>& map,
                                          const std::vector<NotRun>& notRun, const Circumstances& circumstances);

} // namespace toile::study::stability
