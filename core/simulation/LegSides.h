// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/body/Landmarks.h"
#include "core/pattern/Pattern.h"

namespace toile::simulation {

/// The pattern with the pieces of a trouser leg moved sideways until nothing of them below the crotch lies
/// before or behind the other leg: an inside seam that starts there is drawn round the wrong side of it. A
/// piece of which a quarter or more lies on the other side belongs to both legs, and stays.
[[nodiscard]] pattern::Pattern withLegsApart(const pattern::Pattern& pattern, const body::Body& body);

} // namespace toile::simulation
