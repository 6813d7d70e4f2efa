// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Circumstances.h"
#include "core/study/Front.h"
#include "core/study/GarmentAccuracy.h"

#include <string>
#include <vector>

namespace toile::study {

/// Cost and error of a run as they may be claimed: a run nearer to the reference than its runs are to each other stands
/// at the edge of the band.
[[nodiscard]] CostError claimedOf(const GarmentRun& run, const GarmentReference& reference);
/// The runs that no other beats in both, by rising cost. Runs with a status do not count.
[[nodiscard]] std::vector<const GarmentRun*> frontOf(const GarmentAccuracy& study);

/// Whether the defaults lie on the front, and what beats them, in plain words; or why nothing is said.
[[nodiscard]] std::string verdictOn(const GarmentAccuracy& study);
/// The cheapest setting all of whose lengths are right within so much [m]; or why there is none.
[[nodiscard]] std::string suggestion(const GarmentAccuracy& study, double within);

/// Tables, verdict and, if that is asked, the suggestion, in Markdown.
[[nodiscard]] std::string garmentText(const GarmentAccuracy& study, const std::optional<double>& within,
                                      const Circumstances& circumstances);
[[nodiscard]] std::string gnuplotScript(const GarmentAccuracy& study, const std::string& file);

} // namespace toile::study
