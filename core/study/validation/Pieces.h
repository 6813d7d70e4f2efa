// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simulation/Scene.h"

#include <fmt/format.h>
#include <string>
#include <vector>

/// Small patterns.
namespace toile::study::validation {

/// A piece with straight edges; vertices v0…, edges e0… from v0 to v1 and so on.
inline pattern::Piece polygonPiece(const std::string& id, const std::vector<Vec2>& corners, double spacing) {
    pattern::Piece piece;
    piece.id = pattern::PieceId(id);
    piece.name = id;
    piece.fabric = material::FabricId("cloth");
    piece.spacing = spacing;
    int i = 0;
    for (const Vec2 corner : corners) {
        piece.outline.vertices.push_back({pattern::VertexId(fmt::format("v{}", i)), corner});
        piece.outline.edges.push_back({pattern::EdgeId(fmt::format("e{}", i)), geometry::LineShape{}, {}});
        ++i;
    }
    return piece;
}

inline material::Fabric plainCloth() {
    material::Fabric fabric;
    fabric.id = material::FabricId("cloth");
    fabric.name = "cloth";
    return fabric;
}

inline pattern::Seam seamBetween(const std::string& id, const std::string& pieceA, const std::string& edgeA,
                                 const std::string& pieceB, const std::string& edgeB) {
    pattern::Seam seam;
    seam.id = pattern::SeamId(id);
    seam.name = id;
    seam.sides[0].push_back({pattern::PieceId(pieceA), pattern::EdgeId(edgeA), 0, 1, false});
    seam.sides[1].push_back({pattern::PieceId(pieceB), pattern::EdgeId(edgeB), 0, 1, true});
    return seam;
}

/// Two squares of 0.2 m side by side, 0.2 m apart, to be sewn along the facing edges; nothing else in the world.
inline simulation::Scene twoSquares(double spacing = 0.02) {
    simulation::Scene scene;
    scene.settings.gravity = {};
    scene.pattern.fabrics.push_back(plainCloth());
    for (const char* id : {"left", "right"}) {
        pattern::Piece piece = polygonPiece(id, {{0, 0}, {0.2, 0}, {0.2, 0.2}, {0, 0.2}}, spacing);
        piece.placement = pattern::Placement{};
        piece.placement->transform.origin = {id == std::string("left") ? -0.3 : 0.1, 1, 0};
        scene.pattern.pieces.push_back(std::move(piece));
    }
    scene.pattern.seams.push_back(seamBetween("middle", "left", "e1", "right", "e3"));
    return scene;
}

} // namespace toile::study::validation
