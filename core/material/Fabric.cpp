// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/Fabric.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace toile::material {
namespace {

constexpr double gravity = 9.81; // [m/s²]

Place placeOf(const Fabric& fabric) {
    return {.object = fmt::format("fabric \"{}\"", fabric.name)};
}

} // namespace

Result<MembraneStiffness> membraneStiffness(const Fabric& fabric, double c12) {
    // Uniaxial: E2 = C11 − C12²/C22, E1 = C22 − C12²/C11. With q = C12²: the two give
    // C11 = E2·r, C22 = E1·r and E1·E2·r² − E1·E2·r − q = 0.
    const double product = fabric.warpStiffness * fabric.weftStiffness, q = c12 * c12;
    if (product <= 0) {
        if (q > 0)
            return fail(
                ErrorCode::invalidInput,
                "A fabric that does not resist stretching along warp and weft cannot have a coupling of the two, "
                "nor shear stiffness if it is woven.",
                placeOf(fabric));
        return MembraneStiffness{fabric.weftStiffness, fabric.warpStiffness, 0, fabric.shearStiffness};
    }
    const double r = 0.5 * (1 + std::sqrt(1 + 4 * q / product));
    const MembraneStiffness c{fabric.weftStiffness * r, fabric.warpStiffness * r, c12, fabric.shearStiffness};
    if (c.c11 * c.c22 <= q)
        return fail(ErrorCode::invalidInput, "The coupling of warp and weft is too large: C11·C22 must exceed C12².",
                    placeOf(fabric));
    return c;
}

double bendingStiffness(const Fabric& fabric, double angleFromWarp) {
    const double c = std::cos(angleFromWarp), s = std::sin(angleFromWarp);
    const double c2 = c * c, s2 = s * s;
    const double mixed = 4 * fabric.biasBending - fabric.warpBending - fabric.weftBending;
    return fabric.warpBending * c2 * c2 + fabric.weftBending * s2 * s2 + mixed * c2 * s2;
}

double bendingLength(const Fabric& fabric) {
    return std::cbrt(0.5 * (fabric.warpBending + fabric.weftBending) / (fabric.arealDensity * gravity));
}

double proposedSpacing(const Fabric& fabric) {
    constexpr double millimetre = 1e-3;
    return std::max(1.0, std::floor(0.5 * bendingLength(fabric) / millimetre + 1e-9)) * millimetre;
}

Result<void> checked(const Fabric& fabric) {
    const auto bad = [&](const char* field, double value, const char* wanted) -> Result<void> {
        Place place = placeOf(fabric);
        place.path = field;
        return fail(ErrorCode::invalidInput, fmt::format("{} is {}, but must be {}.", field, value, wanted),
                    std::move(place));
    };
    struct Field {
        const char* name;
        double value;
        bool zeroAllowed;
    };
    const Field fields[] = {
        {"arealDensity", fabric.arealDensity, false},  {"warpStiffness", fabric.warpStiffness, true},
        {"weftStiffness", fabric.weftStiffness, true}, {"shearStiffness", fabric.shearStiffness, true},
        {"coupling", fabric.coupling, true},           {"warpBending", fabric.warpBending, true},
        {"weftBending", fabric.weftBending, true},     {"biasBending", fabric.biasBending, true},
        {"thickness", fabric.thickness, false},        {"friction", fabric.friction, true},
    };
    for (const Field& f : fields) {
        if (!std::isfinite(f.value)) return bad(f.name, f.value, "a finite number");
        if (f.zeroAllowed && f.value < 0) return bad(f.name, f.value, "zero or more");
        if (!f.zeroAllowed && f.value <= 0) return bad(f.name, f.value, "positive");
    }
    struct Curve {
        const char* name;
        const std::vector<TensionPoint>& points;
    };
    for (const Curve& curve : {Curve{"warpTension", fabric.warpTension}, Curve{"weftTension", fabric.weftTension}})
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            const TensionPoint& p = curve.points[i];
            if (!std::isfinite(p.strain) || !std::isfinite(p.modulusFactor) || p.modulusFactor <= 0 ||
                (i > 0 && p.strain <= curve.points[i - 1].strain))
                return bad(curve.name, p.strain, "a list of rising strains with positive factors");
        }
    return {};
}

} // namespace toile::material
