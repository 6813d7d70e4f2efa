// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Circumstances.h"
#include "core/study/Regions.h"

#include <string>
#include <vector>

namespace toile::study {

/// Whether the regions paid, in plain words. Differences below the floor are called none, and noisy times are not
/// compared.
[[nodiscard]] std::string verdictOn(const RegionsStudy& study);

/// The table and the verdict, in Markdown.
[[nodiscard]] std::string regionsText(const RegionsStudy& study, const std::string& document,
                                      const Circumstances& circumstances);

/// One record a layout, the reference last.
[[nodiscard]] std::vector<Json> recordsOf(const RegionsStudy& study, const std::string& document,
                                          const Circumstances& circumstances);
/// Error over particles as `file`.svg and `file`.png.
[[nodiscard]] std::string gnuplotScript(const RegionsStudy& study, const std::string& name, const std::string& file);

} // namespace toile::study
