// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/geometry/Shapes.h"
#include "core/study/EachPiece.h"
#include "core/study/lean/FeatureChapters.h"
#include "core/study/lean/FeatureScenes.h"

#include <memory>
#include <utility>

namespace toile::study::lean {
namespace {

using simulation::Grip;
using simulation::Scene;

Scene withBody(Scene scene, const Vec3& low, const Vec3& high) {
    body::Body box;
    box.name = "box";
    box.mesh = geometry::box(low, high);
    scene.body = Shared<body::Body>(std::move(box));
    return scene;
}

Scene onATable(Scene scene) {
    return withBody(std::move(scene), {-1, 0, -1}, {1, 0.99, 1});
}
Scene farFromABody(Scene scene) {
    return withBody(std::move(scene), {-1, -12, -1}, {1, -10, 1});
}

Feature bodyContact(double spacing) {
    const Scene alone = freeSheet(spacing);
    return {"body contact",
            "body contact",
            {{Role::absent, "no body", alone},
             {Role::forced, "a body 10 m below", farFromABody(alone), 0},
             {Role::inUse, "falling on a table", onATable(alone), 0}}};
}

/// The sheet is pinned where it was, or to the body, which rises by 50 mm a second.
Feature pinsToTheBody(double spacing) {
    const Scene inSpace = farFromABody(heldSheet(spacing));
    Scene toBody = inSpace;
    for (pattern::Pin& pin : toBody.pattern.pins) pin.toBody = true;
    const std::vector<Vec3>& stands = (*inSpace.body)->mesh.vertices;
    geometry::VertexMotion rises{1, {stands, stands}};
    for (Vec3& vertex : rises.poses[1]) vertex.y += 0.05;
    const auto motion = std::make_shared<const geometry::VertexMotion>(std::move(rises));
    return {"pins to the body",
            "pins to the body",
            {{Role::absent, "pinned in space", inSpace},
             {Role::unused, "pinned to a body that stands", toBody, 0},
             {.role = Role::absent, .what = "pinned in space, the body moves", .scene = inSpace, .motion = motion},
             {.role = Role::inUse, .what = "the body moves", .scene = toBody, .like = 2, .motion = motion}}};
}

/// Two sheets, one above the other, the lower one held.
Scene twoLayers(double spacing) {
    Scene scene = sceneOf({sheetPiece("lower", spacing, {0, 1, 0}), sheetPiece("upper", spacing, {0.01, 1.004, 0.01})});
    pin(scene, "lower", {"v0", "v1", "v2", "v3"});
    return scene;
}

Feature selfContact(double spacing) {
    const Scene small = heldSheet(side), large = heldSheet(spacing), layers = twoLayers(spacing);
    return {"self-contact",
            "self-contact",
            {{Role::absent, "one cell, not asked for", small},
             {Role::unused, "one cell, which cannot reach itself", asking(small), 0},
             {Role::forced, "one cell, built all the same", small, 0, {"self-contact"}},
             {Role::absent, "a sheet, not asked for", large},
             {Role::forced, "a sheet that does not reach itself", asking(large), 3},
             {Role::absent, "two layers, not asked for", layers},
             {Role::inUse, "a layer falling on another", asking(layers), 5}}};
}

Feature seams(double spacing) {
    const Scene unsewn = facingSquares(spacing, 0.1), merged = sewn(facingSquares(spacing, 0));
    return {"seams",
            "seams",
            {{Role::absent, "a pattern without a seam", unsewn},
             {Role::forced, "without a seam, built all the same", unsewn, 0, {"seams"}},
             {Role::absent, "a seam that is merged", merged},
             {Role::forced, "merged, built all the same", merged, 2, {"seams"}},
             {Role::inUse, "a seam closing", sewn(unsewn), 0}}};
}

Feature seamsThatMeet(double spacing) {
    const Scene merged = farFromABody(sewn(facingSquares(spacing, 0)));
    return {"seams that meet",
            "seams that meet",
            {{Role::absent, "a body, the seam is merged", merged},
             {Role::forced, "merged, built all the same", merged, 0, {"seams that meet"}},
             {Role::absent, "a seam closing without a body", sewn(facingSquares(spacing, 0.1))},
             {Role::inUse, "a seam closing beside a body", farFromABody(sewn(facingSquares(spacing, 0.1)))}}};
}

Feature tacks(double spacing) {
    const Scene apart = facingSquares(spacing, 0.1);
    Scene tacked = apart;
    pattern::Tack tack;
    tack.id = pattern::TackId("tack");
    tack.ends = {{{pattern::PieceId("left"), {side, side / 2}}, {pattern::PieceId("right"), {0, side / 2}}}};
    tacked.pattern.tacks = {tack};
    return {"tacks",
            "tacks",
            {{Role::absent, "a pattern without a tack", apart},
             {Role::forced, "without a tack, built all the same", apart, 0, {"tacks"}},
             {Role::inUse, "a tack closing", tacked, 0}}};
}

Feature hands(double spacing) {
    const Scene sheet = heldSheet(spacing);
    const std::vector<Grip> grips{{.piece = "sheet", .material = {0.15, 0.05}, .target = {0.15, 1.1, 0}}};
    return {"hands",
            "hands",
            {{Role::absent, "nobody holds the cloth", sheet},
             {Role::unused, "taken hold of and let go", sheet, 0, {}, {}, grips},
             {Role::forced, "nobody, built all the same", sheet, 0, {"hands"}},
             {Role::inUse, "one hand", sheet, 0, {}, grips}}};
}

Feature strainLimit(double spacing) {
    const Scene sheet = heldSheet(spacing);
    const std::vector<Grip> grips{{.piece = "sheet", .material = {0.15, 0.05}, .target = {0.15, 0.5, 0}}};
    return {"strain limit",
            "strain limit",
            {{Role::absent, "nobody holds the cloth", sheet},
             {Role::forced, "nobody, built all the same", sheet, 0, {"strain limit"}},
             {Role::inUse, "one hand that pulls", sheet, 0, {}, grips}}};
}

Feature energyWatch(double spacing) {
    const Scene sheet = heldSheet(spacing);
    const std::vector<Grip> grips{{.piece = "sheet", .material = {0.15, 0.05}, .target = {0.15, 1.1, 0}}};
    return {
        "energy watch",
        "energy watch",
        {{Role::absent, "a hand does work", sheet, -1, {}, grips}, {Role::inUse, "nothing drives the cloth", sheet}}};
}

Scene inAir(Scene scene, const simulation::Air& air) {
    scene.settings.air = air;
    return scene;
}

Feature wind(double spacing) {
    const Scene sheet = heldSheet(spacing);
    return {"wind",
            "wind",
            {{Role::absent, "no air", sheet},
             {Role::unused, "air that does not drag", inAir(sheet, {.wind = {1, 0, 2}, .drag = 0}), 0},
             {Role::forced, "no air, built all the same", sheet, 0, {"wind"}},
             {Role::inUse, "wind", inAir(sheet, {.wind = {1, 0, 2}}), 0}}};
}

Feature pressure(double spacing) {
    const Scene sheet = heldSheet(spacing);
    Scene blown = sheet;
    blown.pattern = eachPiece(sheet.pattern, [](pattern::Piece& piece) { piece.pressure = 2; });
    return {"pressure",
            "pressure",
            {{Role::absent, "no piece with pressure", sheet},
             {Role::forced, "none, built all the same", sheet, 0, {"pressure"}},
             {Role::inUse, "2 Pa behind the sheet", blown, 0}}};
}

} // namespace

std::vector<Feature> stageFeatures(double spacing) {
    return {wind(spacing),          pressure(spacing),    seams(spacing),        tacks(spacing),
            hands(spacing),         strainLimit(spacing), energyWatch(spacing),  bodyContact(spacing),
            seamsThatMeet(spacing), selfContact(spacing), pinsToTheBody(spacing)};
}

} // namespace toile::study::lean
