// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/Plies.h"

#include "core/base/Contracts.h"

namespace toile::material {

Fabric backed(Fabric cloth, const Fabric& ply, int plies) {
    expects(plies >= 0, "a number of plies");
    for (double Fabric::*const constant :
         {&Fabric::arealDensity, &Fabric::warpStiffness, &Fabric::weftStiffness, &Fabric::shearStiffness,
          &Fabric::coupling, &Fabric::warpBending, &Fabric::weftBending, &Fabric::biasBending, &Fabric::thickness})
        cloth.*constant += plies * ply.*constant;
    return cloth;
}

} // namespace toile::material
