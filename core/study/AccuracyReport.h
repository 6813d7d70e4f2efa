// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Accuracy.h"
#include "core/study/Circumstances.h"

#include <string>
#include <vector>

namespace toile::study {

/// "flap-100": of files that belong to a case.
[[nodiscard]] std::string fileNameOf(const CaseResult& result);

/// Tables, orders, the Pareto front and what is concluded, in Markdown. Pictures are named as gnuplotScript() writes
/// them.
[[nodiscard]] std::string accuracyText(const std::vector<CaseResult>& results, const Circumstances& circumstances);

/// A gnuplot program that draws error against run time of a case into NAME.svg and NAME.png beside it.
[[nodiscard]] std::string gnuplotScript(const CaseResult& result, double calibration);

} // namespace toile::study
