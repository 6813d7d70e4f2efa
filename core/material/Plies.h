// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/material/Fabric.h"

namespace toile::material {

/// A cloth with so many plies of a fabric behind it, joined to it at their edges alone, as a yoke or a cuff that is cut
/// double. Pulled they share the load, bent they slip on one another: all stiffnesses, weights and thicknesses add up.
/// Curves of tension stay the cloth's.
[[nodiscard]] Fabric backed(Fabric cloth, const Fabric& ply, int plies);

} // namespace toile::material
