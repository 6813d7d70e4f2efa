// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/Waistband.h"

#include "samples/Strokes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace toile::samples {

using namespace pattern;

Ring ringRound(const body::Body& body, double low, double high, double clearance) {
    constexpr double trunk = 0.25; // arms stand farther out than this at the waist and at the neck [m]
    double front = -std::numeric_limits<double>::infinity(), back = -front;
    const auto counts = [&](const Vec3& p) { return p.y >= low && p.y <= high && std::abs(p.x) < trunk; };
    for (const Vec3& p : body.mesh.vertices)
        if (counts(p)) front = std::max(front, p.z), back = std::min(back, p.z);
    expects(front >= back, "the body has points at the ring's height");
    Ring ring{{0, (low + high) / 2, (front + back) / 2}, 0};
    for (const Vec3& p : body.mesh.vertices)
        if (counts(p)) ring.radius = std::max(ring.radius, std::hypot(p.x, p.z - ring.centre.z) + clearance);
    return ring;
}

Fabric interlined(Fabric fabric) {
    fabric.id = material::FabricId{fabric.id.value + "-interlined"};
    fabric.name += ", interlined";
    fabric.source += " With a fusible interlining of 60 g/m²; its stiffness is an estimate.";
    fabric.arealDensity += 0.060;
    fabric.thickness += 0.2e-3;
    fabric.warpTension.clear();
    fabric.weftTension.clear();
    fabric.warpStiffness = fabric.weftStiffness = 8000;
    fabric.shearStiffness *= 4;
    for (double* bending : {&fabric.warpBending, &fabric.weftBending, &fabric.biasBending}) *bending *= 10;
    return fabric;
}

Piece draftWaistband(const Fabric& fabric, const body::Body& body, const WaistbandSettings& s, double lowered) {
    Piece band = pieceNamed("waistband", "Waistband", fabric, s.spacing);
    const double half = s.length / 2;
    const Vec2 lowRight{-half, 0}, centre{0, 0}, lowLeft{half, 0}, highLeft{half, s.width}, highRight{-half, s.width};
    band.outline =
        contourOf("waistband",
                  {line("low-right", "bottom-right", lowRight, centre), line("centre", "bottom-left", centre, lowLeft),
                   line("low-left", "end-left", lowLeft, highLeft), line("high-left", "top", highLeft, highRight),
                   line("high-right", "end-right", highRight, lowRight)});
    band.grain = std::numbers::pi / 2; // warp runs round the waist
    const double bottom = body.landmarks.waist.y - lowered;
    const Ring ring = ringRound(body, bottom, bottom + s.width, 0.008);
    const double radius = std::max(ring.radius, half / (0.97 * std::numbers::pi));
    band.placement =
        Placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, bottom, ring.centre.z + radius}}, Curl{{0, 1}, radius}};
    return band;
}

void hangOnWaistband(document::Document& skirt) {
    skirt.avatarFile = "bodies/mannequin.glb";
    skirt.scene.substeps = waistbandSubsteps;
    skirt.scene.selfContact = true; // its folds touch
    skirt.scene.damping = 1;        // so much cloth that hangs free swings for long [1/s]
}

Seam waistbandSeam(const Piece& band) {
    return seam("waistband seam", {along(band, "end-left")}, {against(band, "end-right")});
}

} // namespace toile::samples
