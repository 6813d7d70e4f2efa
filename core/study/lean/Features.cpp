// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/lean/Features.h"

#include "core/geometry/Shapes.h"
#include "core/simulation/Simulation.h"
#include "core/study/EachPiece.h"
#include "core/study/validation/Pieces.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace toile::study::lean {
namespace {

using pattern::Piece;
using simulation::Grip;
using simulation::Scene;
using validation::plainCloth;
using validation::polygonPiece;
using validation::seamBetween;

constexpr double side = 0.3; ///< of a sheet [m]

/// Right side up, its warp away from the viewer.
Transform level(const Vec3& origin) {
    return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, origin};
}

Piece sheetPiece(const std::string& id, double spacing, const Vec3& origin) {
    Piece piece = polygonPiece(id, {{0, 0}, {side, 0}, {side, side}, {0, side}}, spacing);
    piece.placement = pattern::Placement{};
    piece.placement->transform = level(origin);
    return piece;
}

Scene sceneOf(std::vector<Piece> pieces) {
    Scene scene;
    scene.pattern.fabrics.push_back(plainCloth());
    for (Piece& piece : pieces) scene.pattern.pieces.push_back(std::move(piece));
    return scene;
}

void pin(Scene& scene, const std::string& piece, std::initializer_list<const char*> vertices) {
    for (const char* vertex : vertices)
        scene.pattern.pins.push_back(
            {pattern::PinId(piece + vertex), pattern::PieceId(piece), pattern::VertexId(vertex)});
}

/// A sheet of 0.3 m in the air, in no plane of the axes' mirror: free, or held at its far corners.
Scene freeSheet(double spacing) {
    return sceneOf({sheetPiece("sheet", spacing, {0, 1, 0})});
}
Scene heldSheet(double spacing) {
    Scene scene = freeSheet(spacing);
    pin(scene, "sheet", {"v2", "v3"});
    return scene;
}

template <class Change>
Scene withFabric(Scene scene, const Change& change) {
    material::Fabric fabric = *scene.pattern.fabrics.front();
    change(fabric);
    scene.pattern.fabrics.front() = Shared<material::Fabric>(std::move(fabric));
    return scene;
}

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

Scene asking(Scene scene) {
    scene.settings.selfContact = true;
    return scene;
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

/// Two squares with their sides facing each other, so far apart.
Scene facingSquares(double spacing, double gap) {
    Scene scene =
        sceneOf({sheetPiece("left", spacing, {-side - gap / 2, 1, 0}), sheetPiece("right", spacing, {gap / 2, 1, 0})});
    pin(scene, "left", {"v0", "v3"});
    return scene;
}
Scene sewn(Scene scene) {
    scene.pattern.seams.push_back(seamBetween("middle", "left", "e1", "right", "e3"));
    return scene;
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

Feature pins(double spacing) {
    return {"pins",
            "pins",
            {{Role::absent, "a free sheet", freeSheet(spacing)}, {Role::inUse, "two corners", heldSheet(spacing), 0}}};
}

Scene withRegion(const Scene& scene, int refinement) {
    Scene painted = scene;
    painted.pattern = eachPiece(scene.pattern, [refinement](Piece& piece) {
        pattern::Region region;
        region.id = pattern::RegionId("middle");
        region.name = "middle";
        region.outline = {{0.1, 0.1}, {0.2, 0.1}, {0.2, 0.2}, {0.1, 0.2}};
        region.refinement = refinement;
        piece.regions = {region};
    });
    return painted;
}

Feature slaves(double spacing) {
    const Scene sheet = heldSheet(spacing);
    return {"regions",
            "slaves",
            {{Role::absent, "one spacing", sheet},
             {Role::unused, "a region no finer and no stiffer than its piece", withRegion(sheet, 0), 0},
             {Role::inUse, "a region at half the spacing", withRegion(sheet, 1), 0}}};
}

Feature cells(double spacing) {
    const Scene woven = heldSheet(spacing);
    const Scene knit = withFabric(woven, [](material::Fabric& fabric) { fabric.kind = material::FabricKind::knit; });
    return {"membrane cells",
            "membrane cells",
            {{Role::absent, "woven cloth", woven}, {Role::inUse, "knitted cloth", knit, 0}}};
}

Feature springs(double spacing) {
    Feature turned = cells(spacing);
    std::swap(turned.variants[0].scene, turned.variants[1].scene);
    std::swap(turned.variants[0].what, turned.variants[1].what);
    turned.name = turned.part = "springs";
    return turned;
}

Feature triangles(double spacing) {
    Scene slanted = heldSheet(spacing);
    slanted.pattern = eachPiece(slanted.pattern, [](Piece& piece) { piece.outline.vertices[1].position.x -= 0.05; });
    return {"membrane triangles",
            "membrane triangles",
            {{Role::absent, "a square", heldSheet(spacing)}, {Role::inUse, "with a slanted side", slanted, 0}}};
}

Scene bent(const Scene& scene, double stiffness, double bias) {
    return withFabric(scene, [&](material::Fabric& fabric) {
        fabric.warpBending = fabric.weftBending = stiffness;
        fabric.biasBending = bias;
    });
}

/// Forced by a stiffness that is there and moves nothing.
Feature bending(double spacing) {
    constexpr double nothing = 1e-30, poplin = 20e-6; // [N·m]
    const Scene sheet = heldSheet(spacing);
    return {"bending",
            "bending",
            {{Role::absent, "no bending stiffness", bent(sheet, 0, 0)},
             {Role::forced, "1e-30 N·m", bent(sheet, nothing, nothing / 2), 0},
             {Role::inUse, "20 µN·m", bent(sheet, poplin, poplin / 2), 0}}};
}

Feature twist(double spacing) {
    const double stiffness = std::ldexp(1.0, -16); // its half is the bias stiffness without twist, to the last bit
    const Scene sheet = heldSheet(spacing);
    return {"twist",
            "twist",
            {{Role::absent, "4·B45 = B1 + B2", bent(sheet, stiffness, stiffness / 2)},
             {Role::forced, "4·B45 greater by rounding", bent(sheet, stiffness, std::nextafter(stiffness / 2, 1)), 0},
             {Role::inUse, "B45 = B1 = B2", bent(sheet, stiffness, stiffness), 0}}};
}

Feature seamHinges(double spacing) {
    const Scene unsewn = facingSquares(spacing, 0), merged = sewn(unsewn);
    return {"seam hinges",
            "seam hinges",
            {{Role::absent, "two pieces without a seam", unsewn},
             {Role::absent, "a merged seam of cloth without bending", bent(merged, 0, 0)},
             {Role::forced, "the same of 1e-30 N·m", bent(merged, 1e-30, 0.5e-30), 1},
             {Role::inUse, "a merged seam", merged, 0}}};
}

Feature folds(double spacing) {
    const Scene sheet = heldSheet(spacing);
    Scene pressed = sheet;
    pressed.pattern = eachPiece(sheet.pattern, [](Piece& piece) {
        pattern::Fold fold;
        fold.id = pattern::FoldId("fold");
        fold.ends = {{{piece.outline.edges[1].id, 0.5}, {piece.outline.edges[3].id, 0.5}}};
        fold.angle = 1;
        piece.folds = {fold};
    });
    return {"folds", "folds", {{Role::absent, "no fold", sheet}, {Role::inUse, "a fold across", pressed, 0}}};
}

/// A strip of 120 springs that hangs by its upper side.
Scene longStrip() {
    constexpr double spacing = 0.01;
    Piece strip = polygonPiece("strip", {{0, 0}, {0.1, 0}, {0.1, 1.2}, {0, 1.2}}, spacing);
    strip.placement = pattern::Placement{};
    strip.placement->transform.origin = {0, 0.2, 0};
    Scene scene = sceneOf({std::move(strip)});
    pin(scene, "strip", {"v2", "v3"});
    return scene;
}

Scene withSubsteps(Scene scene, int substeps) {
    scene.settings.substeps = substeps;
    return scene;
}

int substepsOf(const Scene& scene) {
    const auto simulation = simulation::Simulation::create(scene);
    return simulation ? simulation->substeps() : 0; // the run will say why
}

Feature coarseLevels(double spacing) {
    constexpr int wanted = 99; // of the strip without levels
    const Scene sheet = heldSheet(spacing);
    return {"coarse levels",
            "coarse levels",
            {{Role::absent, "the scene says how many substeps", withSubsteps(sheet, substepsOf(sheet))},
             {Role::unused, "so many substeps suffice", sheet, 0},
             {Role::absent, "a strip of 120 springs, all its substeps", withSubsteps(longStrip(), wanted)},
             {Role::inUse, "a strip of 120 springs", longStrip(), 2}}};
}

Feature damping(double spacing) {
    const auto damped = [spacing](double coefficient) {
        Scene scene = heldSheet(spacing);
        scene.settings.damping = coefficient;
        return scene;
    };
    return {"damping",
            "",
            {{Role::absent, "none", damped(0)},
             {Role::forced, "1e-20 1/s", damped(1e-20), 0},
             {Role::inUse, "0.5 1/s", damped(0.5), 0}}};
}

} // namespace

std::string_view nameOf(Role role) {
    switch (role) {
    case Role::absent: return "absent";
    case Role::unused: return "unused";
    case Role::forced: return "forced";
    case Role::inUse: return "in use";
    }
    return "";
}

std::vector<Feature> allFeatures(bool quick) {
    const double spacing = quick ? 0.02 : 0.01;
    return {seams(spacing),       tacks(spacing),       hands(spacing), bodyContact(spacing), seamsThatMeet(spacing),
            selfContact(spacing), springs(spacing),     cells(spacing), triangles(spacing),   bending(spacing),
            twist(spacing),       seamHinges(spacing),  folds(spacing), slaves(spacing),      pins(spacing),
            damping(spacing),     coarseLevels(spacing)};
}

Feature garmentFeature(const std::string& name, const Scene& scene) {
    Scene off = scene;
    off.settings.selfContact = false;
    Feature feature{name, "self-contact", {{Role::absent, "without self-contact", off}}};
    if (const auto simulation = simulation::Simulation::create(off)) {
        const auto isLeftOut = [&](std::string_view stage) { return !simulation->plan().find(stage); };
        std::vector<std::string> idle{"hands"};
        if (scene.pattern.seams.empty())
            for (const char* stage : {"seams", "seams that meet"})
                if (isLeftOut(stage)) idle.emplace_back(stage);
        feature.variants.push_back(
            {Role::forced, fmt::format("{} built all the same", fmt::join(idle, ", ")), off, 0, idle});
    }
    feature.variants.push_back({Role::inUse, "with self-contact", asking(scene)});
    return feature;
}

} // namespace toile::study::lean
