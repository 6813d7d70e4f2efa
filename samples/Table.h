// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

namespace toile::samples {

/// The pattern with its pieces side by side in rows on the pattern table, 5 cm apart, in their order.
[[nodiscard]] pattern::Pattern laidOut(pattern::Pattern pattern, double rowWidth = 2.06);

} // namespace toile::samples
