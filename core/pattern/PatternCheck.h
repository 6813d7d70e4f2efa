// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"
#include "core/pattern/Problem.h"

#include <vector>

namespace toile::pattern {

/// Lengths of the two sides of a seam's section that are not declared as ease may differ by so much [m].
struct SeamTolerance {
    double silent = 0.001;      ///< or this share of the section, whichever is larger:
    double silentShare = 0.003; ///< [–]
    double warning = 0.003;     ///< up to here a warning, above an error
};

/// Everything in a pattern that does not fit together, in the order of the file. Paths begin at the document:
/// "pieces[2].vertices[0]". Without errors the pattern can be meshed.
[[nodiscard]] std::vector<Problem> checkPattern(const Pattern& pattern, const SeamTolerance& tolerance = {});

[[nodiscard]] bool hasErrors(const std::vector<Problem>& problems);

} // namespace toile::pattern
