// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/material/FabricPresets.h"

#include "core/base/Contracts.h"

#include <array>
#include <string>
#include <utility>

namespace toile::material {
namespace {

constexpr double curveStrain = 1.0 / 6; ///< where the second row of the tension tables was measured [–]

/// A row of the measurements, directions as measured: 0°, 45°, 90°.
struct Row {
    const char *id, *name;
    FabricKind kind;                     ///< from fibre and stiffness; the measurements do not say
    double density;                      ///< [kg/m²]
    std::array<double, 2> tension;       ///< at zero strain, 0° and 90° [N/m]
    std::array<double, 2> tensionCurved; ///< secant at 1/6 strain [N/m]
    double shear;                        ///< factor of the squared tensor shear [N/m]
    std::array<double, 3> bending;       ///< [µN·m]
    double thickness;                    ///< estimated [m]
};

constexpr auto woven = FabricKind::woven, knit = FabricKind::knit;

constexpr Row rows[] = {
    {"11oz-black-denim",
     "Stretch denim, black",
     woven,
     0.324,
     {411, 2028},
     {464, 2103},
     106.8,
     {64.2, 73.4, 97.0},
     0.8e-3},
    {"camel-ponte-roma", "Ponte roma, camel", knit, 0.284, {62, 88}, {157, 384}, 63.8, {36.3, 33.0, 37.2}, 1.0e-3},
    {"gray-interlock", "Interlock, grey", knit, 0.187, {33, 69}, {93, 812}, 73.7, {23.2, 24.7, 14.3}, 0.8e-3},
    {"ivory-rib-knit", "Rib knit, ivory", knit, 0.276, {86, 130}, {105, 509}, 166.4, {46.2, 30.0, 32.2}, 1.1e-3},
    {"navy-sparkle-sweat",
     "Sweatshirt knit, navy",
     knit,
     0.224,
     {25, 6.5},
     {64, 487},
     35.2,
     {59.5, 40.1, 45.6},
     1.0e-3},
    {"pink-ribbon-brown",
     "Blanket cloth, brown",
     woven,
     0.228,
     {303, 490},
     {328, 720},
     60.5,
     {117.1, 87.5, 59.8},
     1.5e-3},
    {"royal-target",
     "Trouser cloth, royal blue",
     woven,
     0.220,
     {4033, 4070},
     {4219, 4306},
     209.5,
     {125.4, 108.0, 125.4},
     0.5e-3},
    {"tango-red-jet-set", "Jacket cloth, red", knit, 0.113, {86, 343}, {150, 810}, 28.6, {14.3, 22.0, 20.3}, 0.4e-3},
    {"white-dots-on-blk",
     "Tablecloth, white dots",
     woven,
     0.128,
     {4004, 4055},
     {4215, 4301},
     38.4,
     {51.7, 40.7, 31.3},
     0.3e-3},
    {"white-swim-solid", "Swimsuit knit, white", knit, 0.204, {96, 209}, {81, 249}, 121.5, {60.2, 58.8, 51.0}, 0.7e-3},
};

Fabric fabricOf(const Row& row) {
    Fabric f;
    f.id = FabricId{row.id};
    f.name = row.name;
    f.kind = row.kind;
    f.arealDensity = row.density;
    f.warpStiffness = row.tension[0];
    f.weftStiffness = row.tension[1];
    f.shearStiffness = row.shear / 2; // as the forces that were fitted use it; the energy's text gives half of this
    f.warpBending = 1e-6 * row.bending[0];
    f.biasBending = 1e-6 * row.bending[1];
    f.weftBending = 1e-6 * row.bending[2];
    f.thickness = row.thickness;
    if (row.kind == knit) {
        f.warpTension = {{0, 1}, {curveStrain, row.tensionCurved[0] / row.tension[0]}};
        f.weftTension = {{0, 1}, {curveStrain, row.tensionCurved[1] / row.tension[1]}};
    }
    f.source = "Wang, O'Brien, Ramamoorthi 2011, material file " + std::string(row.id) +
               ": density, tension, shear (known to a factor 2), bending. Thickness and friction estimated.";
    return f;
}

Fabric measured(const std::string& id) {
    for (const Row& row : rows)
        if (row.id == id) return fabricOf(row);
    expects(false, "the measured fabric exists");
    return {};
}

/// Warp and weft exchanged.
Fabric turned(Fabric f) {
    std::swap(f.warpStiffness, f.weftStiffness);
    std::swap(f.warpBending, f.weftBending);
    std::swap(f.warpTension, f.weftTension);
    return f;
}

Fabric named(Fabric f, const char* id, const char* name, const char* source) {
    f.id = FabricId{id};
    f.name = name;
    f.source = source;
    return f;
}

void setBending(Fabric& f, double warp, double weft, double bias) {
    f.warpBending = warp;
    f.weftBending = weft;
    f.biasBending = bias;
}

} // namespace

std::vector<Fabric> measuredFabrics() {
    std::vector<Fabric> fabrics;
    for (const Row& row : rows) fabrics.push_back(fabricOf(row));
    return fabrics;
}

std::vector<Fabric> everydayFabrics() {
    return {poplin(), chiffon(), twill(), denim(), jersey(), rib()};
}

Fabric poplin() {
    Fabric f =
        named(measured("white-dots-on-blk"), "poplin", "Cotton poplin",
              "Tension as measured for white-dots-on-blk (Wang 2011). Density, shear, bending, thickness and friction "
              "are estimates for a shirting: bending near the lower quartile of 617 fabrics (DrapeTester 2022).");
    f.arealDensity = 0.120;
    f.shearStiffness = 45;
    setBending(f, 8e-6, 5e-6, 6e-6);
    f.thickness = 0.25e-3;
    return f;
}

Fabric chiffon() {
    Fabric f =
        named({}, "chiffon", "Silk-like chiffon",
              "Density and bending as measured for row 3 of DrapeTester 2022. Tension, shear, thickness and friction "
              "are estimates.");
    f.arealDensity = 0.0585;
    f.warpStiffness = f.weftStiffness = 1500;
    f.shearStiffness = 15;
    setBending(f, 2.98e-6, 4.97e-6, 6.62e-6);
    f.thickness = 0.15e-3;
    f.friction = 0.25;
    return f;
}

Fabric twill() {
    Fabric f = named(measured("royal-target"), "twill", "Cotton twill",
                     "Tension and shear as measured for royal-target (Wang 2011), density and bending for row 231 of "
                     "DrapeTester 2022. Thickness and friction are estimates.");
    f.arealDensity = 0.1965;
    setBending(f, 61.7e-6, 16.5e-6, 20.9e-6);
    return f;
}

Fabric denim() {
    return named(
        turned(measured("11oz-black-denim")), "denim", "Stretch denim",
        "11oz-black-denim (Wang 2011) with 90° as warp, because elastane lies in the weft. Thickness and friction "
        "are estimates.");
}

Fabric jersey() {
    Fabric f =
        named(turned(measured("gray-interlock")), "jersey", "Cotton jersey",
              "Tension with its curves, shear and bending of gray-interlock (Wang 2011) with 90° as wale. The density "
              "is that of a lighter T-shirt; it, thickness and friction are estimates.");
    f.arealDensity = 0.160;
    f.thickness = 0.6e-3;
    return f;
}

Fabric rib() {
    return named(turned(measured("ivory-rib-knit")), "rib", "Rib knit",
                 "ivory-rib-knit (Wang 2011) with 90° as wale. Thickness and friction are estimates.");
}

} // namespace toile::material
