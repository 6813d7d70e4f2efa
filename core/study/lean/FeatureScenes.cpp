// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/lean/FeatureScenes.h"

#include "core/study/validation/Pieces.h"

namespace toile::study::lean {

using pattern::Piece;
using simulation::Scene;
using validation::plainCloth;
using validation::polygonPiece;
using validation::seamBetween;

namespace {

/// Right side up, its warp away from the viewer.
Transform level(const Vec3& origin) {
    return {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, origin};
}

} // namespace

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

Scene freeSheet(double spacing) {
    return sceneOf({sheetPiece("sheet", spacing, {0, 1, 0})});
}

Scene heldSheet(double spacing) {
    Scene scene = freeSheet(spacing);
    pin(scene, "sheet", {"v2", "v3"});
    return scene;
}

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

Scene asking(Scene scene) {
    scene.settings.selfContact = true;
    return scene;
}

} // namespace toile::study::lean
