// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/Interfacing.h"

#include <cmath>
#include <fmt/format.h>

namespace toile::material {

Fabric fused(Fabric fabric, const Interfacing& interfacing) {
    fabric.arealDensity += interfacing.arealDensity;
    for (double* bending : {&fabric.warpBending, &fabric.weftBending, &fabric.biasBending})
        *bending *= interfacing.bendingFactor;
    return fabric;
}

Result<void> checked(const Interfacing& interfacing) {
    if (const double factor = interfacing.bendingFactor; !(factor >= 1 && std::isfinite(factor)))
        return fail(
            ErrorCode::invalidInput,
            fmt::format("Interfacing makes cloth stiffer: its bendingFactor is {}, but must be 1 or more.", factor),
            {.path = "bendingFactor"});
    if (const double density = interfacing.arealDensity; !(density >= 0 && std::isfinite(density)))
        return fail(ErrorCode::invalidInput,
                    fmt::format("The arealDensity of interfacing is {}, but must be zero or more.", density),
                    {.path = "arealDensity"});
    return {};
}

} // namespace toile::material
