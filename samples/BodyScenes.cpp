// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/BodyScenes.h"

#include "core/material/FabricPresets.h"
#include "samples/Lathe.h"
#include "samples/Sewing.h"
#include "samples/Strokes.h"

#include <cmath>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

constexpr double ballRadius = 0.10, ballHeight = 1.0; // [m]
constexpr double capsuleRadius = 0.12, capsuleBottom = 0.4, capsuleTop = 1.3;
constexpr double quarter = std::numbers::pi / 2;

/// The cloth of the hanging sheets of the literature, soft enough to fold on itself.
Fabric plainCloth() {
    Fabric fabric;
    fabric.id = FabricId{"plain-cloth"};
    fabric.name = "Plain cloth, 500 N/m";
    fabric.arealDensity = 0.2;
    fabric.warpStiffness = fabric.weftStiffness = 500;
    fabric.shearStiffness = 50;
    fabric.warpBending = fabric.weftBending = fabric.biasBending = 1e-5;
    fabric.source = "Invented: round numbers, for scenes that other programs can set up as well.";
    return fabric;
}

/// From one height on the axis of a lathe up to another, along an arc about a point of the axis.
void addArc(std::vector<Vec2>& profile, double radius, double middle, double from, double to, int steps) {
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        const double out = std::abs(angle) == quarter ? 0 : radius * std::cos(angle);
        profile.push_back({out, middle + radius * std::sin(angle)});
    }
}

} // namespace

document::Document clothOverBall(const ClothOverBall& cloth) {
    document::Document document;
    const Fabric fabric = plainCloth();
    Piece square = pieceNamed("square", "Square", fabric, cloth.spacing);
    const double half = cloth.side / 2;
    square.outline = contourOf("square", rectangle({-half, -half}, {half, half}));
    square.placement = Placement{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {0, ballHeight + ballRadius + 0.05, 0}}, {}};
    document.pattern.fabrics = {fabric};
    document.pattern.pieces = {square};
    document.avatarFile = "bodies/ball.glb";
    document.scene.selfContact = true;
    return document;
}

document::Document capsuleTunic(const CapsuleTunic& tunic) {
    const Fabric fabric = material::poplin();
    const double side = tunic.width / 2, neck = tunic.neck / 2;
    const auto panel = [&](const std::string& id, const std::string& name, bool behind) {
        Piece piece = pieceNamed(id, name, fabric, tunic.spacing);
        const Vec2 right{side, 0}, left{-side, 0};
        piece.outline = contourOf(id, {line("bottom-left", "bottom", {-side, -tunic.height}, {side, -tunic.height}),
                                       line("bottom-right", "right", {side, -tunic.height}, right),
                                       line("top-right", "shoulder-right", right, {neck, 0}),
                                       line("neck-right", "neck", {neck, 0}, {-neck, 0}),
                                       line("neck-left", "shoulder-left", {-neck, 0}, left),
                                       line("top-left", "left", left, {-side, -tunic.height})});
        const double turn = behind ? -1 : 1; // its right side faces away from the body
        piece.placement =
            Placement{{{turn, 0, 0}, {0, 1, 0}, {0, 0, turn}, {0, capsuleTop, turn * (capsuleRadius + 0.025)}}, {}};
        return piece;
    };
    const Piece front = panel("front", "Front", false), back = panel("back", "Back", true);
    document::Document document;
    document.pattern.fabrics = {fabric};
    document.pattern.pieces = {front, back};
    document.pattern.seams = {
        seam("side left", {along(front, "right")}, {against(back, "left")}),
        seam("side right", {along(front, "left")}, {against(back, "right")}),
        seam("shoulder left", {along(front, "shoulder-right")}, {against(back, "shoulder-left")}),
        seam("shoulder right", {along(front, "shoulder-left")}, {against(back, "shoulder-right")}),
    };
    document.avatarFile = "bodies/capsule.glb";
    document.scene.selfContact = true;
    return document;
}

geometry::TriangleMesh ballMesh() {
    std::vector<Vec2> profile;
    addArc(profile, ballRadius, ballHeight, -quarter, quarter, 64);
    return lathed(profile, 128);
}

geometry::TriangleMesh capsuleMesh() {
    constexpr double low = capsuleBottom + capsuleRadius, high = capsuleTop - capsuleRadius;
    constexpr int rings = 24; // of the cylinder between the caps
    std::vector<Vec2> profile;
    addArc(profile, capsuleRadius, low, -quarter, 0, 24);
    for (int i = 1; i < rings; ++i) profile.push_back({capsuleRadius, low + (high - low) * i / rings});
    addArc(profile, capsuleRadius, high, 0, quarter, 24);
    return lathed(profile, 128);
}

} // namespace toile::samples
