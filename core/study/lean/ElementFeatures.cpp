// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/EachPiece.h"
#include "core/study/lean/FeatureChapters.h"
#include "core/study/lean/FeatureScenes.h"

#include <cmath>

namespace toile::study::lean {
namespace {

using pattern::Piece;
using simulation::Scene;

template <class Change>
Scene withFabric(Scene scene, const Change& change) {
    material::Fabric fabric = *scene.pattern.fabrics.front();
    change(fabric);
    scene.pattern.fabrics.front() = Shared<material::Fabric>(std::move(fabric));
    return scene;
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

Feature elastics(double spacing) {
    const Scene plain = sewn(facingSquares(spacing, 0));
    Scene drawn = plain;
    drawn.pattern.seams.front().elastic = pattern::Elastic{};
    return {"elastics",
            "elastics",
            {{Role::absent, "a merged seam", plain}, {Role::inUse, "an elastic sewn into it", drawn, 0}}};
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

} // namespace

std::vector<Feature> elementFeatures(double spacing) {
    return {springs(spacing),    cells(spacing),    triangles(spacing), bending(spacing), twist(spacing),
            seamHinges(spacing), elastics(spacing), folds(spacing),     slaves(spacing),  pins(spacing)};
}

} // namespace toile::study::lean
