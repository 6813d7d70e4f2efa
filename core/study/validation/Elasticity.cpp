// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cloth/Forces.h"
#include "core/geometry/Polygon.h"
#include "core/study/validation/Cases.h"
#include "core/study/validation/Sheets.h"

#include <fmt/format.h>

namespace toile::study::validation {

namespace {

/// A homogeneous small strain of the plane, weft x and warp y.
struct PlaneStrain {
    double weft = 0, warp = 0, shear = 0; ///< shear: the whole angle [rad]
};

std::vector<Vec3> strained(const Patch& patch, const PlaneStrain& e, double amount) {
    std::vector<Vec3> x;
    for (const Vec2& m : patch.material)
        x.push_back({m.x + amount * (e.weft * m.x + 0.5 * e.shear * m.y),
                     m.y + amount * (e.warp * m.y + 0.5 * e.shear * m.x), 0});
    return x;
}

double areaOf(const Patch& patch, const ClothModel& model, const Fabric& fabric) {
    double mass = 0;
    for (double m : model.mass) mass += m;
    return patch.material.empty() ? 0 : mass / fabric.arealDensity;
}

constexpr double small = 1e-6; // strain of V19; the odd part of ±small leaves an error of its square

/// (σ(strain) : direction) / amount, from the work of the forces: the constant that couples the two strains [N/m].
double constant(const Patch& patch, const ClothModel& model, const Fabric& fabric, const PlaneStrain& strain,
                const PlaneStrain& direction) {
    const auto virtualMotion = strained(patch, direction, 1), rest = strained(patch, direction, 0);
    double work = 0;
    for (double sign : {1.0, -1.0}) {
        const auto x = strained(patch, strain, sign * small);
        std::vector<Vec3> forces(x.size());
        cloth::addForces(model, x, forces);
        for (std::size_t p = 0; p < x.size(); ++p) work -= sign * dot(forces[p], virtualMotion[p] - rest[p]);
    }
    return work / (2 * small * areaOf(patch, model, fabric));
}

constexpr PlaneStrain weft{1, 0, 0}, warp{0, 1, 0}, shear{0, 0, 1};

struct Mesh {
    const char* name;
    Patch patch;
    cloth::CellForm form;
};

std::vector<Mesh> meshes() {
    const std::vector<double> unequal{0, 0.01, 0.025, 0.033, 0.05}, even = evenLines(0.04, 4);
    return {
        {"square spring cells", gridPatch(even, even), cloth::CellForm::springs},
        {"spring cells, unequal rows", gridPatch(unequal, even), cloth::CellForm::springs},
        {"spring cells, two regions with slaves", twoRegionPatch(0.04, 4, 0.02, 2, 0.04, 4), cloth::CellForm::springs},
        {"spring cells, regions 1 : 4", twoRegionPatch(0.04, 2, 0.02, 1, 0.04, 4, 4), cloth::CellForm::springs},
        {"triangles", trianglePatch(unequal, even), cloth::CellForm::springs},
        {"membrane cells, unequal rows", gridPatch(unequal, even), cloth::CellForm::membrane},
        {"membrane cells, two regions", twoRegionPatch(0.04, 4, 0.02, 2, 0.04, 4), cloth::CellForm::membrane},
    };
}

/// One row of the fabrics measured by Wang, O'Brien, Ramamoorthi 2011; shear constant: half the force's.
Fabric measured(const char* name, bool knit, double density, double e1, double e2, double shearColumn) {
    Fabric fabric;
    fabric.name = name;
    fabric.kind = knit ? material::FabricKind::knit : material::FabricKind::woven;
    fabric.arealDensity = density;
    fabric.warpStiffness = e1;
    fabric.weftStiffness = e2;
    fabric.shearStiffness = shearColumn / 2;
    return fabric;
}

std::vector<Fabric> measuredFabrics() {
    return {measured("11oz-black-denim", false, 0.324, 411, 2028, 106.8),
            measured("camel-ponte-roma", true, 0.284, 62, 88, 63.8),
            measured("gray-interlock", true, 0.187, 33, 69, 73.7),
            measured("ivory-rib-knit", true, 0.276, 86, 130, 166.4),
            measured("navy-sparkle-sweat", true, 0.224, 25, 6.5, 35.2),
            measured("pink-ribbon-brown", false, 0.228, 303, 490, 60.5),
            measured("royal-target", false, 0.220, 4033, 4070, 209.5),
            measured("tango-red-jet-set", false, 0.113, 86, 343, 28.6),
            measured("white-dots-on-blk", false, 0.128, 4004, 4055, 38.4),
            measured("white-swim-solid", true, 0.204, 96, 209, 121.5)};
}

/// Largest force on a node that is free when the strip's ends at material x = 0 and x = width are held, and the pull
/// at the far end [N].
struct Pull {
    double rest = 0, end = 0;
};
Pull pullOf(const std::vector<Vec2>& places, double width, const ClothModel& model, std::vector<Vec3> x) {
    std::vector<Vec3> forces(x.size());
    cloth::addForces(model, x, forces);
    cloth::gatherToMasters(model, forces);
    Pull pull;
    for (std::size_t p = 0; p < x.size(); ++p) {
        if (places[p].x > width - 1e-9) pull.end -= forces[p].x;
        else if (places[p].x > 1e-9) pull.rest = std::max(pull.rest, length(forces[p]));
    }
    return pull;
}

void v19HomogeneousStrainsMeetTheConstants(Findings& found) {
    const Fabric fabric = unequalWeave();
    for (const Mesh& mesh : meshes()) {
        const ClothModel model = modelOf(mesh.patch, fabric, mesh.form);
        const bool springs = mesh.form == cloth::CellForm::springs;
        const auto c = material::membraneStiffness(fabric, springs ? fabric.shearStiffness : fabric.coupling);
        if (!found.ran(c)) return;
        const auto check = [&](const char* name, double expected, const PlaneStrain& a, const PlaneStrain& b) {
            const double value = constant(mesh.patch, model, fabric, a, b);
            const std::string what = fmt::format("{}, {}", mesh.name, name);
            if (expected == 0) found.atMost(what, 1e-6 * c->c33, std::abs(value));
            else found.within(what, expected, value, 1e-6);
        };
        check("C11", c->c11, weft, weft);
        check("C22", c->c22, warp, warp);
        check("C12", c->c12, weft, warp);
        check("C33", c->c33, shear, shear);
    }
}

void v19FreeSidesShowTheUniaxialModulus(Findings& found) {
    const Fabric fabric = unequalWeave();
    for (const Mesh& mesh : meshes()) {
        const ClothModel model = modelOf(mesh.patch, fabric, mesh.form);
        const double c12 = mesh.form == cloth::CellForm::springs ? fabric.shearStiffness : fabric.coupling;
        const auto c = material::membraneStiffness(fabric, c12);
        const auto box = geometry::boundsOf(mesh.patch.material);
        const PlaneStrain uniaxial{1, -c12 / c->c22, 0};
        const Pull out = pullOf(mesh.patch.material, box.high.x, model, strained(mesh.patch, uniaxial, small));
        const Pull in = pullOf(mesh.patch.material, box.high.x, model, strained(mesh.patch, uniaxial, -small));
        const double modulus = (out.end - in.end) / (2 * small * box.high.y);
        found.within(fmt::format("{}, uniaxial", mesh.name), fabric.weftStiffness, modulus, 1e-6);
        // second order in the strain: small² against small
        found.atMost(fmt::format("{}, forces of free nodes", mesh.name), 1e-5,
                     out.rest / (fabric.weftStiffness * small * box.high.y));
    }
}

void v19bMeasuredFabricsAtThreeAspects(Findings& found) {
    for (const Fabric& fabric : measuredFabrics())
        for (int aspect : {1, 2, 4}) {
            const Patch patch = gridPatch(evenLines(0.02 * aspect, 4), evenLines(0.02, 4));
            ClothModel model;
            const auto report = cloth::appendPatch(model, patch, fabric);
            if (!found.ran(report)) return;
            if (report->clampedCells > 0) found.stop("A cell would need a negative spring.");
            const auto c =
                material::membraneStiffness(fabric, report->membraneCells ? fabric.coupling : fabric.shearStiffness);
            const char* cells = report->membraneCells ? "membrane" : "springs";
            const auto check = [&](const char* name, double expected, const PlaneStrain& e) {
                found.within(fmt::format("{}, aspect {}, {}, {}", fabric.name, aspect, cells, name), expected,
                             constant(patch, model, fabric, e, e), 0.01);
            };
            check("C11", c->c11, weft);
            check("C22", c->c22, warp);
            check("C33", c->c33, shear);
        }
}

void v20BiasStripStretchesAsItsComplianceSays(Findings& found) {
    const Fabric fabric = unequalWeave();
    const auto c = material::membraneStiffness(fabric, fabric.shearStiffness);
    const double d = c->c11 * c->c22 - c->c12 * c->c12;
    const double s11 = c->c22 / d, s22 = c->c11 / d, s12 = -c->c12 / d, s33 = 1 / c->c33;
    const double expected = 4 / (s11 + s22 + 2 * s12 + s33);
    // A strip of triangles along x whose weft lies 45 degrees to it.
    Patch strip = trianglePatch(evenLines(0.1, 10), evenLines(0.03, 3));
    const std::vector<Vec2> places = strip.material;
    for (Vec2& m : strip.material) m = geometry::rotated(m, -std::numbers::pi / 4);
    const ClothModel model = modelOf(strip, fabric);
    // Strain of a pull of 1 N/m along x, in weft and warp, turned back to the strip.
    const double ew = 0.5 * (s11 + s12), ep = 0.5 * (s12 + s22), g = -0.5 * s33; // pull along (1, −1)/√2
    std::array<Pull, 2> pulls;
    for (int side : {0, 1}) {
        std::vector<Vec3> x;
        for (std::size_t n = 0; n < places.size(); ++n) {
            const Vec2 m = strip.material[n];
            const double t = (side == 0 ? 1 : -1) * small * expected;
            const Vec2 moved{m.x + t * (ew * m.x + 0.5 * g * m.y), m.y + t * (ep * m.y + 0.5 * g * m.x)};
            const Vec2 p = geometry::rotated(moved, std::numbers::pi / 4);
            x.push_back({p.x, p.y, 0});
        }
        pulls[side] = pullOf(places, 0.1, model, x);
    }
    const double modulus = (pulls[0].end - pulls[1].end) / (2 * small * 0.03);
    found.within("bias strip of triangles, E45", expected, modulus, 1e-4);
    found.atMost("bias strip, forces of free nodes", 1e-4, pulls[0].rest / (expected * small * 0.03));
}

/// A wool of 168 g/m² as a laboratory of FAST reports it: bending lengths in mm, stiffness in µN·m.
void v30UnitsOfFast(Findings& found) {
    struct Row {
        double length, stiffness;
    };
    for (const Row& row : {Row{15.00, 5.56}, {14.50, 5.02}}) {
        Fabric wool = unequalWeave();
        wool.arealDensity = 0.168;
        wool.warpBending = wool.weftBending = wool.biasBending = 168 * std::pow(row.length, 3) * 9.81e-6 * 1e-6;
        found.within(fmt::format("FAST, 168 g/m², c = {:.2f} mm: B [µN·m], as reported", row.length), row.stiffness,
                     1e6 * wool.warpBending, 0.005 / row.stiffness); // its last digit
        found.within("the same: our bending length [mm]", row.length, 1e3 * material::bendingLength(wool), 1e-12);
    }
}

} // namespace

std::vector<Case> elasticityCases() {
    constexpr std::string_view theme = "elasticity";
    return {
        {"V19", theme, "homogeneous strains of rectangles and triangles", v19HomogeneousStrainsMeetTheConstants},
        {"V19", theme, "a strip with free sides", v19FreeSidesShowTheUniaxialModulus},
        {"V19b", theme, "ten measured fabrics at three aspects", v19bMeasuredFabricsAtThreeAspects},
        {"V20", theme, "bias extension", v20BiasStripStretchesAsItsComplianceSays},
        {"V30", theme, "units of FAST", v30UnitsOfFast},
    };
}

} // namespace toile::study::validation
