// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/SmallScenes.h"
#include "samples/Placing.h"

#include "core/material/FabricPresets.h"
#include "samples/Lathe.h"
#include "samples/Sewing.h"
#include "samples/Strokes.h"

#include <cmath>
#include <numbers>

namespace toile::samples {
namespace {

using namespace pattern;

constexpr double tableRadius = 0.45, tableHeight = 0.735; // [m]
constexpr double cylinderRadius = 0.10, cylinderHeight = 0.60;

Fabric linearCloth(const std::string& id, double stiffness) {
    Fabric fabric;
    fabric.id = FabricId{id};
    fabric.name = "Linear test cloth";
    fabric.kind = material::FabricKind::knit;
    fabric.warpStiffness = fabric.weftStiffness = stiffness;
    fabric.shearStiffness = 0.4 * stiffness;
    fabric.warpBending = fabric.weftBending = fabric.biasBending = 5e-6;
    fabric.source = "Invented: equal and linear in warp and weft, for scenes with a closed form.";
    return fabric;
}

/// The square with its upper edge cut into pieces of one spacing, so that each of its nodes can be held.
std::vector<Stroke> squareWithDividedTop(double side, int parts) {
    std::vector<Stroke> strokes = rectangle({-side / 2, -side / 2}, {side / 2, side / 2});
    const Stroke left = strokes.back();
    strokes.resize(2);
    for (int i = 0; i < parts; ++i) {
        const auto x = [&](int k) { return side / 2 - side * k / parts; };
        const std::string number = std::to_string(i);
        strokes.push_back(line(i == 0 ? "top-right" : "top-" + number, "top-" + number, {x(i), side / 2},
                               {i + 1 == parts ? -side / 2 : x(i + 1), side / 2}));
    }
    strokes.push_back(left);
    return strokes;
}

void pin(Pattern& pattern, const Piece& piece, const std::string& vertex) {
    pattern.pins.push_back({PinId{"pin-" + vertex}, piece.id, vertexId(piece.id.value, vertex)});
}

} // namespace

document::Document squareSheet(SheetPins pins, double side, double spacing) {
    document::Document document;
    Pattern& pattern = document.pattern;
    const Fabric fabric = material::poplin();
    pattern.fabrics = {fabric};
    Piece sheet = pieceNamed("sheet", "Sheet", fabric, spacing);
    sheet.placement = Placement{lyingAt({0, 1.5, 0}), {}};
    pin(pattern, sheet, "top-right");
    pin(pattern, sheet, "top-left");
    if (pins == SheetPins::twoCorners) {
        sheet.outline = contourOf("sheet", rectangle({-side / 2, -side / 2}, {side / 2, side / 2}));
    } else {
        const int parts = static_cast<int>(std::ceil(side / spacing - 1e-9));
        sheet.outline = contourOf("sheet", squareWithDividedTop(side, parts));
        for (int i = 1; i < parts; ++i) pin(pattern, sheet, "top-" + std::to_string(i));
    }
    pattern.pieces = {sheet};
    return document;
}

document::Document tablecloth(double spacing) {
    document::Document document;
    const Fabric fabric = material::measuredFabrics()[8]; // a tablecloth's
    Piece cloth = pieceNamed("tablecloth", "Tablecloth", fabric, spacing);
    cloth.outline = contourOf("tablecloth", rectangle({-0.6, -0.6}, {0.6, 0.6}));
    cloth.placement = Placement{lyingAt({0, tableHeight + 0.02, 0}), {}};
    document.pattern.fabrics = {fabric};
    document.pattern.pieces = {cloth};
    document.avatarFile = "bodies/table.glb";
    document.scene.selfContact = true; // as it falls, its corners strike their own folds
    return document;
}

document::Document tableEdge(double spacing) {
    constexpr double width = 0.2, lying = 0.8, hanging = 0.2; // [m]
    document::Document document;
    const Fabric fabric = material::poplin();
    Piece strip = pieceNamed("strip", "Strip", fabric, spacing);
    strip.outline =
        contourOf("strip", rectangle({-width / 2, -tableRadius - hanging}, {width / 2, lying - tableRadius}));
    strip.placement = Placement{lyingAt({0, tableHeight + 0.005, 0}), {}};
    document.pattern.fabrics = {fabric};
    document.pattern.pieces = {strip};
    document.avatarFile = "bodies/table.glb";
    document.scene.damping = 2; // what hangs swings for long
    return document;
}

document::Document tubeRoundCylinder(const TubeScene& scene) {
    document::Document document;
    const Fabric fabric = linearCloth("linear-cloth", scene.stiffness);
    Piece tube = pieceNamed("tube", "Tube", fabric, scene.spacing);
    const double half = std::numbers::pi * scene.restRadius;
    tube.outline = contourOf("tube", rectangle({-half, -scene.height / 2}, {half, scene.height / 2}));
    const double radius = cylinderRadius + 0.01; // clear of the body; the seam closes the rest
    tube.placement =
        Placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, cylinderHeight / 2, radius}}, Curl{{0, 1}, radius}};
    document.pattern.fabrics = {fabric};
    document.pattern.pieces = {tube};
    document.pattern.seams = {seam("tube seam", {along(tube, "right")}, {against(tube, "left")})};
    document.avatarFile = "bodies/cylinder.glb";
    document.scene.gravity = {0, 0, 0};
    document.scene.bodyFriction = 0;
    return document;
}

document::Document buttonedBand(const ButtonedBand& band) {
    constexpr double onCylinder = cylinderRadius + 0.003; // its skin offset
    const double half = std::numbers::pi * (onCylinder + band.ease), beyond = band.overlap / 2;
    const Fabric fabric = material::poplin();
    const auto front = [&](const std::string& id, const std::string& name, double from, double to, double radius) {
        Piece piece = pieceNamed(id, name, fabric, band.spacing);
        piece.outline = contourOf(id, rectangle({from, -band.height / 2}, {to, band.height / 2}));
        piece.placement =
            Placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, cylinderHeight / 2, radius}}, Curl{{0, 1}, radius}};
        return piece;
    };
    const Piece left = front("front-left", "Front left", -beyond, half, band.leftStart);
    Piece right = front("front-right", "Front right", -half, beyond, band.rightStart);
    right.layer = 1;

    document::Document document;
    document.pattern.fabrics = {fabric};
    document.pattern.pieces = {left, right};
    document.pattern.seams = {seam("centre back", {along(left, "right")}, {against(right, "left")})};
    for (int i = 0; i < 3; ++i) { // on the centre line of both
        Tack button;
        button.id = TackId{"button-" + std::to_string(i + 1)};
        button.name = "Button " + std::to_string(i + 1);
        button.ends = {{{left.id, {0, 0.06 * (1 - i)}}, {right.id, {0, 0.06 * (1 - i)}}}};
        button.buttonDiameter = 0.011;
        document.pattern.tacks.push_back(button);
    }
    document.avatarFile = "bodies/cylinder.glb";
    document.scene.gravity = {0, 0, 0};
    document.scene.bodyFriction = 0;
    document.scene.selfContact = true;
    return document;
}

document::Document twoSquares(double side, double spacing) {
    document::Document document;
    const Fabric fabric = material::poplin();
    const auto square = [&](const std::string& id, const std::string& name, double x) {
        Piece piece = pieceNamed(id, name, fabric, spacing);
        piece.outline = contourOf(id, rectangle({-side / 2, -side / 2}, {side / 2, side / 2}));
        piece.placement = Placement{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {x, 1, 0}}, {}};
        return piece;
    };
    constexpr double gap = 0.2;
    const Piece left = square("left", "Left square", -(side + gap) / 2),
                right = square("right", "Right square", (side + gap) / 2);
    document.pattern.fabrics = {fabric};
    document.pattern.pieces = {left, right};
    document.pattern.seams = {seam("middle", {along(left, "right")}, {against(right, "left")})};
    document.scene.gravity = {0, 0, 0};
    document.scene.damping = 0;
    return document;
}

geometry::TriangleMesh tableMesh() {
    constexpr double rim = 0.040; // radius of the rounding: cells of 25 mm must be able to follow it
    std::vector<Vec2> profile{{0, 0},       {0.20, 0},    {0.22, 0.01},
                              {0.20, 0.02}, {0.05, 0.04}, {0.04, 0.10},
                              {0.04, 0.60}, {0.05, 0.64}, {0.20, tableHeight - 2 * rim}};
    constexpr int steps = 16;
    for (int i = 0; i <= steps; ++i) { // half a circle from the underside to the top
        const double angle = std::numbers::pi * (static_cast<double>(i) / steps - 0.5);
        profile.push_back({tableRadius - rim + rim * std::cos(angle), tableHeight - rim + rim * std::sin(angle)});
    }
    for (const double radius : {0.40, 0.32, 0.24, 0.16, 0.08}) profile.push_back({radius, tableHeight});
    profile.push_back({0, tableHeight});
    return lathed(profile, 96);
}

geometry::TriangleMesh cylinderMesh() {
    std::vector<Vec2> profile{{0, 0}, {cylinderRadius / 2, 0}};
    constexpr int rings = 24;
    for (int i = 0; i <= rings; ++i) profile.push_back({cylinderRadius, cylinderHeight * i / rings});
    profile.push_back({cylinderRadius / 2, cylinderHeight});
    profile.push_back({0, cylinderHeight});
    return lathed(profile, 128);
}

} // namespace toile::samples
