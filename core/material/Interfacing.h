// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/material/Fabric.h"

namespace toile::material {

/// Interlining fused to the wrong side of a whole piece: of collars, cuffs, plackets, waistbands.
struct Interfacing {
    double bendingFactor =
        10; ///< on all bending stiffnesses of the fabric [–]. Measured on shirt collars: 6 to 15 along
            ///< weft, 20 to 34 along warp. Ref: Lê & Bùi 2018, J. Sci. Technol. (HUST) 124, 45–49
    double arealDensity = 0.05; ///< of interlining and glue, added to the fabric's [kg/m²]; assumed
    friend bool operator==(const Interfacing&, const Interfacing&) = default;
};

/// The fabric with the interlining on it. Tension, shear, thickness and friction stay the fabric's: little is pulled
/// that is fused, and the glue lies inside.
[[nodiscard]] Fabric fused(Fabric fabric, const Interfacing& interfacing);

/// The factor is 1 or more and the density not negative; the sentence names the field, and so does the error's path.
[[nodiscard]] Result<void> checked(const Interfacing& interfacing);

} // namespace toile::material
