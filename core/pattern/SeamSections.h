// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pattern/Pattern.h"

namespace toile::pattern {

/// Where sections of seams are declared one by one, they follow the notches: `pattern` is `before` with other notches.
/// Of a section that is divided each part gets its share of the ease, by length of side A, and the gather ratio;
/// sections that become one want together what they wanted. One ease for a whole seam stays what it is.
void divideSectionsAnew(Pattern& pattern, const Pattern& before);

} // namespace toile::pattern
