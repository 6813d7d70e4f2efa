// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cloth/Patch.h"

namespace toile::cloth {

/// Three-point bending along rows and columns of rectangles, hinge stencils on edges with a triangle, twist of
/// rectangles. True if the twist had to be left out.
[[nodiscard]] bool appendBending(ClothModel& model, const Patch& patch, const material::Fabric& fabric);

} // namespace toile::cloth
