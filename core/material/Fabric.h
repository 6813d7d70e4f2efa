// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/Id.h"
#include "core/base/Json.h"
#include "core/base/Result.h"

#include <string>
#include <vector>

namespace toile::material {

struct FabricTag;
using FabricId = Id<FabricTag>;

enum class FabricKind {
    woven, ///< spring cells where they can represent it
    knit,  ///< membrane cells throughout (docs/physics/membrane.md)
};

/// Uniaxial tension at a strain, relative to the zero-strain modulus: one row of a measured curve.
struct TensionPoint {
    double strain = 0;        ///< [–]
    double modulusFactor = 1; ///< secant modulus over the zero-strain modulus [–]
    friend bool operator==(const TensionPoint&, const TensionPoint&) = default;
};

/// Physical constants of a cloth. Warp is y of the material frame, weft is x.
struct Fabric {
    FabricId id;
    std::string name;
    FabricKind kind = FabricKind::woven;

    double arealDensity = 0.15;  ///< ρ [kg/m²]
    double warpStiffness = 1000; ///< E1, uniaxial [N/m]
    double weftStiffness = 1000; ///< E2, uniaxial [N/m]
    double shearStiffness = 40;  ///< G per radian of shear angle [N/m]
    double coupling = 0;         ///< C12 of the membrane cell [N/m]; spring cells have C12 = G
    double warpBending = 20e-6;  ///< B1, bends warp threads [N·m]
    double weftBending = 20e-6;  ///< B2 [N·m]
    double biasBending = 20e-6;  ///< B45 [N·m]
    double thickness = 0.4e-3;   ///< full thickness t [m]
    double friction = 0.4;       ///< μ of the cloth; a pair has √(μ₁·μ₂) [–]

    std::vector<TensionPoint> warpTension, weftTension; ///< empty = linear; strains increase
    std::string source;                                 ///< where the numbers come from
    Json unknown;                                       ///< keys of the file that we do not know; kept

    friend bool operator==(const Fabric&, const Fabric&) = default;
};

/// Membrane constants solved from the uniaxial moduli.
struct MembraneStiffness {
    double c11 = 0, c22 = 0, c12 = 0, c33 = 0; ///< 1 = weft (x), 2 = warp (y), 33 = shear [N/m]
};

/// C11, C22 such that a strip with free sides shows the fabric's uniaxial moduli, for a given C12.
/// Error, by the fabric's name, where C11·C22 ≤ C12².
[[nodiscard]] Result<MembraneStiffness> membraneStiffness(const Fabric& fabric, double c12);

/// Bending stiffness for a fold whose normal lies at an angle from warp [rad], [N·m]:
/// B1·c⁴ + B2·s⁴ + (4·B45 − B1 − B2)·c²s².
[[nodiscard]] double bendingStiffness(const Fabric& fabric, double angleFromWarp);

/// (B/ρg)^(1/3) of the mean bending stiffness [m]: the length over which the cloth holds itself up.
[[nodiscard]] double bendingLength(const Fabric& fabric);

/// The largest main spacing that shows the folds of this cloth [m]: half its bending length, rounded down to a whole
/// millimetre, but at least one.
[[nodiscard]] double proposedSpacing(const Fabric& fabric);

/// Finite, positive where needed; the sentence names the field, and so does the error's path.
[[nodiscard]] Result<void> checked(const Fabric& fabric);

} // namespace toile::material
