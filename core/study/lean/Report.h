// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/Circumstances.h"
#include "core/study/lean/Lean.h"

namespace toile::study::lean {

/// "44 of 44 rows pass.", or which features fail.
[[nodiscard]] std::string summaryOf(const std::vector<FeatureResult>& results);

/// The table in Markdown, every row with its verdict.
[[nodiscard]] std::string leanText(const std::vector<FeatureResult>& results, const Circumstances& circumstances);
} // namespace toile::study::lean
